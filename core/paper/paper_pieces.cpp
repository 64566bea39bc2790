#include "core/paper/paper_pieces.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <opencv2/imgproc.hpp>

namespace handmap {

namespace {

/// Sums from which a line or an ellipse follows.
struct Moments {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

  void add(double px, double py) {
    n += 1.0;
    x += px;
    y += py;
    xx += px * px;
    xy += px * py;
    yy += py * py;
  }
  cv::Point2d mean() const { return {x / n, y / n}; }
};

struct Axes {
  double angle_rad, along, across;  ///< σ
};

Axes axesOf(const Moments& m) {
  const cv::Point2d mean = m.mean();
  const double xx = m.xx / m.n - mean.x * mean.x, yy = m.yy / m.n - mean.y * mean.y;
  const double xy = m.xy / m.n - mean.x * mean.y;
  const double half = std::hypot((xx - yy) / 2.0, xy), middle = (xx + yy) / 2.0;
  double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  if (angle < 0.0) angle += CV_PI;
  return {angle, std::sqrt(std::max(0.0, middle + half)), std::sqrt(std::max(0.0, middle - half))};
}

/// Where two pieces meet in the middle of a stroke.
void findBorders(PaperPieces& pieces, double stroke_px) {
  std::unordered_map<std::uint64_t, Moments> meetings;
  const auto thickest = static_cast<float>(1.2 * stroke_px + 1.0);
  const auto meet = [&](int a, int b, double x, double y) {
    if (a == b) return;
    const auto [low, high] = std::minmax(a, b);
    meetings[static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high)].add(x, y);
  };
  for (int y = 0; y + 1 < pieces.labels.rows; ++y) {
    const int* row = pieces.labels.ptr<int>(y);
    const int* below = pieces.labels.ptr<int>(y + 1);
    const float* off = pieces.off_paper_px.ptr<float>(y);
    for (int x = 0; x + 1 < pieces.labels.cols; ++x) {
      if (off[x] <= 0.0F || off[x] > thickest) continue;
      meet(row[x], row[x + 1], x + 0.5, y);
      meet(row[x], below[x], x, y + 0.5);
    }
  }
  for (const auto& [key, moments] : meetings) {
    const Axes axes = axesOf(moments);
    PieceBorder border;
    border.a = static_cast<int>(key >> 32);
    border.b = static_cast<int>(key & 0xffffffffU);
    border.middle = moments.mean();
    border.angle_rad = axes.angle_rad;
    border.length_px = std::sqrt(12.0) * axes.along;
    border.bend_px = axes.across;
    pieces.borders.push_back(border);
  }
  std::ranges::sort(pieces.borders, {},
                    [](const PieceBorder& border) { return std::pair(border.a, border.b); });
}

}  // namespace

PaperPieces paperPieces(const cv::Mat& ink, double stroke_px) {
  PaperPieces pieces;
  cv::distanceTransform(ink, pieces.off_paper_px, pieces.labels, cv::DIST_L2, 5,
                        cv::DIST_LABEL_CCOMP);
  cv::Mat within;
  cv::distanceTransform(~ink, within, cv::DIST_L2, 3);
  double most = 0.0;
  cv::minMaxLoc(pieces.labels, nullptr, &most);
  const auto count = static_cast<std::size_t>(most) + 1;
  std::vector<Moments> moments(count);
  pieces.thickness.resize(count);
  pieces.box.resize(count);
  pieces.at_edge.resize(count);
  for (int y = 0; y < ink.rows; ++y) {
    const int* labels = pieces.labels.ptr<int>(y);
    const float* thick = within.ptr<float>(y);
    for (int x = 0; x < ink.cols; ++x) {
      if (thick[x] <= 0.0F) continue;
      const auto i = static_cast<std::size_t>(labels[x]);
      cv::Rect& box = pieces.box[i];
      box = moments[i].n == 0.0 ? cv::Rect(x, y, 1, 1) : box | cv::Rect(x, y, 1, 1);
      moments[i].add(x, y);
      pieces.thickness[i] = std::max(pieces.thickness[i], 2.0 * static_cast<double>(thick[x]));
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool any = moments[i].n > 0.0;
    const Axes axes = any ? axesOf(moments[i]) : Axes{};
    const cv::Rect& box = pieces.box[i];
    pieces.area.push_back(moments[i].n);
    pieces.mean.push_back(any ? moments[i].mean() : cv::Point2d());
    pieces.length.push_back(4.0 * axes.along);
    pieces.width.push_back(4.0 * axes.across);
    pieces.axis_rad.push_back(axes.angle_rad);
    pieces.at_edge[i] =
        !any || box.x <= 0 || box.y <= 0 || box.br().x >= ink.cols || box.br().y >= ink.rows;
  }
  findBorders(pieces, stroke_px);
  return pieces;
}

double angleBetween(double a_rad, double b_rad) {
  const double off = std::fmod(std::abs(a_rad - b_rad), CV_PI);
  return std::min(off, CV_PI - off);
}

}  // namespace handmap
