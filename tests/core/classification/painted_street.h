// Streets as a child would paint them: a house with windows, trees, sky and road, and the truth.
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/base/random.h"

namespace handmap::test {

inline constexpr int kBuildingClass = 1;

struct PaintedStreet {
  cv::Mat3b image;
  cv::Mat1b classes;  ///< 0 sky, 1 building, 3 road, 5 tree
};

inline void addNoise(cv::Mat3b area, double sigma, RandomStream& random) {
  for (int y = 0; y < area.rows; ++y) {
    for (int x = 0; x < area.cols; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double value = area(y, x)[c] + random.normal(0.0, sigma);
        area(y, x)[c] = cv::saturate_cast<std::uint8_t>(value);
      }
    }
  }
}

/// 160×128: ten by eight windows.
inline PaintedStreet paintStreet(std::uint64_t seed) {
  RandomStream random(seed);
  PaintedStreet street{cv::Mat3b(128, 160, cv::Vec3b(225, 205, 190)),
                       cv::Mat1b(128, 160, std::uint8_t{0})};
  const int horizon = 16 * (5 + random.index(2));
  const int from = 16 * random.index(3);
  const cv::Rect house(from, 16, 64, horizon - 16);
  const cv::Rect tree(from + 80, 32, 48, horizon - 32);
  const cv::Rect road(0, horizon, 160, 128 - horizon);
  const auto fill = [&](const cv::Rect& area, cv::Vec3b colour, std::uint8_t number, double noise) {
    street.image(area) = colour;
    street.classes(area) = number;
    addNoise(street.image(area), noise, random);
  };
  fill(road, {95, 90, 90}, 3, 4.0);
  fill(tree, {40, 90, 60}, 5, 30.0);
  const auto shade = static_cast<std::uint8_t>(random.index(60));
  fill(house, cv::Vec3b(110, 130, static_cast<std::uint8_t>(150 + shade)), kBuildingClass, 4.0);
  for (int y = 20; y + 10 < horizon; y += 16) {
    for (int x = from + 4; x + 8 < from + 64; x += 16) {
      cv::rectangle(street.image, cv::Rect(x, y, 8, 10), {50, 45, 40}, cv::FILLED);
    }
  }
  return street;
}

}  // namespace handmap::test
