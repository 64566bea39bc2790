// Sheets printed, drawn on with a pen and photographed, for tests of what reads them.
#pragma once

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/paper/sheet.h"

namespace handmap::test {

inline constexpr double kDots = 8.0;  ///< pixels a millimetre
inline constexpr double kPaperWidth_mm = 297.0;
inline constexpr double kPaperHeight_mm = 210.0;

inline cv::Point2d onPrint(const Vec2& place_mm) {
  return {kDots * (place_mm.x() + (kPaperWidth_mm - kSheetWidth_mm) / 2.0),
          kDots * (kPaperHeight_mm - place_mm.y() - (kPaperHeight_mm - kSheetHeight_mm) / 2.0)};
}

inline void drawLine(cv::Mat& print, const Polygon& line, const cv::Scalar& colour,
                     double width_mm) {
  std::vector<cv::Point> points;
  for (const Vec2& p : line) points.emplace_back(16.0 * onPrint(p));
  if (width_mm > 0.0) {
    const int width = std::max(1, static_cast<int>(std::lround(kDots * width_mm)));
    cv::polylines(print, points, true, colour, width, cv::LINE_AA, 4);
  } else {
    cv::fillPoly(print, std::vector<std::vector<cv::Point>>{points}, colour, cv::LINE_AA, 4);
  }
}

inline cv::Mat printed(const Sheet& sheet, const Map* map = nullptr) {
  cv::Mat print(static_cast<int>(kDots * kPaperHeight_mm), static_cast<int>(kDots * kPaperWidth_mm),
                CV_8UC3, cv::Scalar::all(240));
  for (const SheetPart& part : sheetParts(sheet, map))
    drawLine(print, part.line, cv::Scalar::all(240.0 * (1.0 - 0.9 * part.darkness)), part.width_mm);
  if (!map) return print;
  for (const SheetName& name : sheetNames(sheet, *map)) {
    const Vec2 left(-0.25 * name.size_mm * static_cast<double>(name.text.size()), 0.0);
    cv::putText(print, name.text, onPrint(name.at + left), cv::FONT_HERSHEY_SIMPLEX,
                kDots * name.size_mm / 30.0, cv::Scalar::all(240.0 * (1.0 - 0.9 * kDarkestPrint)),
                4, cv::LINE_AA);
  }
  return print;
}

/// With a pen of half a millimetre.
inline void penned(cv::Mat& print, const Polygon& outline_mm) {
  drawLine(print, outline_mm, {70, 40, 30}, 0.5);
}

struct Shot {
  double tilt = 0.0;        ///< of the camera from straight above, radians
  double azimuth = 0.0;     ///< to which side it is tilted
  double roll = 0.0;        ///< about its own axis
  double shadow = 0.0;      ///< share of the light that half of the picture is without
  double crumple_mm = 0.0;  ///< how far the paper is from flat
  double noise = 0.0;       ///< σ, grey levels
  std::uint64_t seed = 1;
};

/// Paper pushed about as waves of some centimetres push it.
inline cv::Mat crumpled(const cv::Mat& print, const Shot& shot) {
  cv::RNG random(shot.seed);
  const double phase = random.uniform(0.0, 6.0), turn = random.uniform(0.0, 3.0);
  cv::Mat x(print.size(), CV_32F), y(print.size(), CV_32F);
  cv::Mat light(print.size(), CV_32FC3);
  for (int row = 0; row < print.rows; ++row) {
    for (int col = 0; col < print.cols; ++col) {
      const double wave = (col * std::cos(turn) + row * std::sin(turn)) / (kDots * 14.0) + phase;
      const double other = (row * std::cos(turn) - col * std::sin(turn)) / (kDots * 9.0);
      x.at<float>(row, col) =
          static_cast<float>(col + 0.3 * kDots * shot.crumple_mm * std::sin(wave));
      y.at<float>(row, col) =
          static_cast<float>(row + 0.3 * kDots * shot.crumple_mm * std::sin(wave + other));
      const double shade = 1.0 + 0.1 * shot.crumple_mm * std::cos(wave + other);
      light.at<cv::Vec3f>(row, col) = cv::Vec3f::all(static_cast<float>(shade));
    }
  }
  cv::Mat moved;
  cv::remap(print, moved, x, y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  moved.convertTo(moved, CV_32FC3);
  moved = moved.mul(light);
  moved.convertTo(moved, CV_8UC3);
  return moved;
}

/// 2,400 by 1,800 pixels, on a dark table.
inline cv::Mat photographed(const cv::Mat& flat, const Shot& shot) {
  const cv::Size size(2400, 1800);
  const cv::Mat print = shot.crumple_mm > 0.0 ? crumpled(flat, shot) : flat;
  const double focal = 2200.0, away = 440.0;  // millimetres
  cv::Matx33d tilt, roll;
  cv::Rodrigues(shot.tilt * cv::Vec3d(std::cos(shot.azimuth), std::sin(shot.azimuth), 0.0), tilt);
  cv::Rodrigues(cv::Vec3d(0.0, 0.0, shot.roll), roll);
  const cv::Matx33d turn = roll * tilt;
  std::vector<cv::Point2f> from, to;
  for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
    from.emplace_back(static_cast<float>(corner.x() * print.cols),
                      static_cast<float>(corner.y() * print.rows));
    const cv::Vec3d there = turn * cv::Vec3d((corner.x() - 0.5) * kPaperWidth_mm,
                                             (corner.y() - 0.5) * kPaperHeight_mm, 0.0) +
                            cv::Vec3d(0.0, 0.0, away);
    to.emplace_back(static_cast<float>(size.width / 2.0 + focal * there[0] / there[2]),
                    static_cast<float>(size.height / 2.0 + focal * there[1] / there[2]));
  }
  const cv::Rect box = cv::boundingRect(to);  // who takes the photo looks at all of the sheet
  for (cv::Point2f& corner : to)
    corner += cv::Point2f(cv::Point(size) / 2 - (box.tl() + box.br()) / 2);
  cv::Mat photo(size, CV_8UC3, cv::Scalar(50, 60, 75));
  cv::warpPerspective(print, photo, cv::getPerspectiveTransform(from, to), size, cv::INTER_AREA,
                      cv::BORDER_TRANSPARENT);
  photo.convertTo(photo, CV_32FC3);
  const double edge = size.width * (0.35 + 0.3 * static_cast<double>(shot.seed % 7) / 6.0);
  for (int x = 0; x < size.width; ++x) {
    const double in_shadow = 1.0 / (1.0 + std::exp((x - edge) / 15.0));
    photo.col(x) *= 1.0 - shot.shadow * in_shadow;
  }
  cv::Mat noise(size, CV_32FC3);
  cv::RNG random(shot.seed);
  random.fill(noise, cv::RNG::NORMAL, 0.0, shot.noise);
  photo += noise;
  cv::GaussianBlur(photo, photo, {}, 0.7);
  photo.convertTo(photo, CV_8UC3);
  return photo;
}

}  // namespace handmap::test
