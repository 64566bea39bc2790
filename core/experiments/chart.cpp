#include "core/experiments/chart.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace handmap {

namespace {

constexpr int kWidth = 1200;
constexpr int kHeight = 750;
constexpr int kShift = 4;  // OpenCV draws at sixteenths of a pixel
constexpr double kFont = 0.6;
constexpr double kDodge = 7.0;  // pixels between the bars of two series at one x
const cv::Rect2d kPlot(90.0, 90.0, kWidth - 130.0, kHeight - 170.0);
const cv::Scalar kInk(40, 40, 40);
const cv::Scalar kGrid(225, 225, 225);

struct Style {
  cv::Scalar colour;  // BGR
  cv::MarkerTypes marker;
  bool dashed;
};

Style styleOf(SeriesLook look) {
  switch (look) {
    case SeriesLook::Handmap:
      return {{178, 114, 0}, cv::MARKER_SQUARE, false};
    case SeriesLook::Paper:
      return {{0, 94, 213}, cv::MARKER_TRIANGLE_UP, false};
    case SeriesLook::Odometry:
      return {{120, 120, 120}, cv::MARKER_CROSS, true};
    case SeriesLook::Drawing:
      break;
  }
  return {{40, 40, 40}, cv::MARKER_DIAMOND, true};
}

cv::Point fine(const cv::Point2d& point) {
  constexpr double kScale = 1 << kShift;
  return {cvRound(point.x * kScale), cvRound(point.y * kScale)};
}

class Painter {
 public:
  explicit Painter(const Chart& chart)
      : chart_(chart), picture_(kHeight, kWidth, CV_8UC3, cv::Scalar::all(255)) {
    double highest = 0.0;
    double farthest = 0.0;
    for (const ChartSeries& series : chart.series) {
      for (const ChartPoint& point : series.points) {
        farthest = std::max(farthest, point.x);
        highest = std::max(highest, point.y.high);
      }
    }
    if (!chart.categories.empty()) {
      least_x_ = -0.5;
      most_x_ = static_cast<double>(chart.categories.size()) - 0.5;
    } else if (farthest > 0.0) {
      most_x_ = chart.kind == Chart::Kind::Bars ? 1.05 * farthest : farthest;
    }
    y_max_ = chart.y_max.value_or(highest > 0.0 ? highest * 1.05 : 1.0);
  }

  cv::Mat paint() {
    grid();
    const auto middle = (static_cast<double>(chart_.series.size()) - 1.0) / 2.0;
    for (std::size_t i = 0; i < chart_.series.size(); ++i) {
      const double dodge = kDodge * (static_cast<double>(i) - middle);
      if (chart_.kind == Chart::Kind::Band) {
        band(chart_.series[i]);
      } else {
        bars(chart_.series[i], dodge);
      }
    }
    for (const ChartSeries& series : chart_.series) {
      if (chart_.kind == Chart::Kind::Band) curve(series);
    }
    frame();
    legend();
    return picture_;
  }

 private:
  cv::Point2d at(double x, double y) const {
    return {kPlot.x + kPlot.width * (x - least_x_) / (most_x_ - least_x_),
            kPlot.br().y - kPlot.height * std::min(y / y_max_, 1.0)};
  }

  void line(const cv::Point2d& a, const cv::Point2d& b, const cv::Scalar& colour, int thickness) {
    cv::line(picture_, fine(a), fine(b), colour, thickness, cv::LINE_AA, kShift);
  }

  /// `align`: 0 begins at the place, 0.5 is centred on it, 1 ends there.
  void text(const std::string& words, const cv::Point2d& place, double align,
            double scale = kFont) {
    int below = 0;
    const cv::Size size = cv::getTextSize(words, cv::FONT_HERSHEY_SIMPLEX, scale, 1, &below);
    cv::putText(picture_, words, {cvRound(place.x - align * size.width), cvRound(place.y)},
                cv::FONT_HERSHEY_SIMPLEX, scale, kInk, 1, cv::LINE_AA);
  }

  void grid() {
    const double step_y = tickStep(y_max_);
    for (int i = 0; i * step_y <= y_max_ * (1.0 + 1e-9); ++i) {
      const cv::Point2d left = at(least_x_, i * step_y);
      line(left, at(most_x_, i * step_y), kGrid, 1);
      text(fmt::format("{:.6g}", i * step_y), left + cv::Point2d(-10.0, 6.0), 1.0);
    }
    if (chart_.categories.empty()) {
      const double step = tickStep(most_x_ - least_x_);
      for (int i = 0; i * step <= most_x_ * (1.0 + 1e-9); ++i) {
        line(at(i * step, 0.0), at(i * step, y_max_), kGrid, 1);
        text(fmt::format("{:.6g}", i * step), at(i * step, 0.0) + cv::Point2d(0.0, 26.0), 0.5);
      }
    }
    for (std::size_t i = 0; i < chart_.categories.size(); ++i) {
      text(chart_.categories[i], at(static_cast<double>(i), 0.0) + cv::Point2d(0.0, 26.0), 0.5);
    }
  }

  void bars(const ChartSeries& series, double dodge) {
    const Style style = styleOf(series.look);
    const cv::Point2d aside(dodge, 0.0);
    const cv::Point2d tip(4.0, 0.0);
    for (const ChartPoint& point : series.points) {
      const cv::Point2d low = at(point.x, point.y.low) + aside;
      const cv::Point2d high = at(point.x, point.y.high) + aside;
      line(low, high, style.colour, 2);
      line(low - tip, low + tip, style.colour, 2);
      line(high - tip, high + tip, style.colour, 2);
      cv::drawMarker(picture_, at(point.x, point.y.value) + aside, style.colour, style.marker, 12,
                     2, cv::LINE_AA);
    }
  }

  void band(const ChartSeries& series) {
    if (series.points.empty()) return;
    std::vector<cv::Point> edge;
    for (const ChartPoint& point : series.points) edge.push_back(fine(at(point.x, point.y.high)));
    for (auto point = series.points.rbegin(); point != series.points.rend(); ++point) {
      edge.push_back(fine(at(point->x, point->y.low)));
    }
    cv::Mat over = picture_.clone();
    cv::fillPoly(over, std::vector<std::vector<cv::Point>>{edge}, styleOf(series.look).colour,
                 cv::LINE_AA, kShift);
    cv::addWeighted(over, 0.25, picture_, 0.75, 0.0, picture_);
  }

  void curve(const ChartSeries& series) {
    for (std::size_t i = 1; i < series.points.size(); ++i) {
      stroke(at(series.points[i - 1].x, series.points[i - 1].y.value),
             at(series.points[i].x, series.points[i].y.value), styleOf(series.look));
    }
  }

  void stroke(const cv::Point2d& a, const cv::Point2d& b, const Style& style) {
    const cv::Point2d middle = style.dashed ? a + 0.55 * (b - a) : b;
    line(a, middle, style.colour, 2);
  }

  void frame() {
    line(kPlot.tl(), {kPlot.x, kPlot.br().y}, kInk, 1);
    line({kPlot.x, kPlot.br().y}, kPlot.br(), kInk, 1);
    text(chart_.title, {kPlot.x, 36.0}, 0.0, 0.8);
    text(chart_.y_label, {20.0, kPlot.y - 22.0}, 0.0);
    text(chart_.x_label, {kPlot.x + kPlot.width / 2.0, kHeight - 22.0}, 0.5);
  }

  void legend() {
    cv::Point2d place(kPlot.br().x, kPlot.y - 22.0);
    for (auto series = chart_.series.rbegin(); series != chart_.series.rend(); ++series) {
      const Style style = styleOf(series->look);
      text(series->name, place, 1.0);
      int below = 0;
      place.x -= cv::getTextSize(series->name, cv::FONT_HERSHEY_SIMPLEX, kFont, 1, &below).width;
      const cv::Point2d mark = place + cv::Point2d(-20.0, -6.0);
      if (chart_.kind == Chart::Kind::Band) {
        stroke(mark - cv::Point2d(14.0, 0.0), mark, style);
        stroke(mark, mark + cv::Point2d(14.0, 0.0), style);
      } else {
        cv::drawMarker(picture_, mark, style.colour, style.marker, 12, 2, cv::LINE_AA);
      }
      place.x -= 60.0;
    }
  }

  const Chart& chart_;
  cv::Mat picture_;
  double least_x_ = 0.0;
  double most_x_ = 1.0;
  double y_max_ = 1.0;
};

}  // namespace

double tickStep(double most) {
  if (!(most > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(most / 5.0)));
  const double fraction = most / 5.0 / power;
  return power * (fraction < 2.0 ? 1.0 : fraction < 5.0 ? 2.0 : 5.0);
}

cv::Mat drawn(const Chart& chart) { return Painter(chart).paint(); }

}  // namespace handmap
