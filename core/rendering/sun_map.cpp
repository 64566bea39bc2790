#include "core/rendering/sun_map.h"

#include <cmath>

namespace handmap {

namespace {

constexpr double kCell_m = 0.125;
constexpr double kReach_m = 80.0;
constexpr double kEdgeOn = 1e-3;  // to the light: nothing is shaded by that alone
constexpr double kBias_m = 0.05;  // a surface does not shade itself

}  // namespace

SunMap::SunMap(const Vec2& centre, const Vec3& to_sun)
    : to_sun_(to_sun), per_height_(to_sun.head<2>() / to_sun.z()) {
  // Cells stay where they are in the world however the robot moves.
  low_ = ((centre - Vec2::Constant(kReach_m)) / kCell_m).array().floor() * kCell_m;
  const int side = static_cast<int>(2.0 * kReach_m / kCell_m);
  height_ = cv::Mat1f::zeros(side, side);
}

Vec2 SunMap::cellOf(const Vec3& point) const {
  const Vec2 ground = point.head<2>() - point.z() * per_height_;
  return (ground - low_) / kCell_m - Vec2::Constant(0.5);
}

void SunMap::add(const std::vector<Surface>& surfaces) {
  for (const Surface& surface : surfaces) draw(surface);
}

void SunMap::draw(const Surface& surface) {
  const double towards = surface.normal.dot(to_sun_) / to_sun_.z();
  if (std::abs(towards) < kEdgeOn) return;
  std::array<Vec2, Surface::kMostCorners> cells;
  cells.fill(Vec2::Zero());
  double top = 1e300;
  double bottom = -1e300;
  for (std::size_t i = 0; i < surface.count; ++i) {
    cells[i] = cellOf(surface.corners[i]);
    top = std::min(top, cells[i].y());
    bottom = std::max(bottom, cells[i].y());
  }
  // On a plane the height is affine over the cells.
  const Vec2 slope = -kCell_m / towards * surface.normal.head<2>();
  const double base = surface.corners[0].z() - slope.dot(cells[0]);
  const int first = static_cast<int>(std::ceil(std::clamp(top, 0.0, 1.0 * height_.rows)));
  const int last = static_cast<int>(std::ceil(std::clamp(bottom, 0.0, 1.0 * height_.rows)));
  for (int row = first; row < last; ++row) {
    double left = 1e300;
    double right = -1e300;
    for (std::size_t i = 0, j = surface.count - 1; i < surface.count; j = i++) {
      if ((cells[i].y() < row) == (cells[j].y() < row)) continue;
      const double x = cells[i].x() + (row - cells[i].y()) / (cells[j].y() - cells[i].y()) *
                                          (cells[j].x() - cells[i].x());
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int begin = static_cast<int>(std::ceil(std::clamp(left, 0.0, 1.0 * height_.cols)));
    const int end = static_cast<int>(std::ceil(std::clamp(right, 0.0, 1.0 * height_.cols)));
    float* const heights = height_[row];
    for (int column = begin; column < end; ++column) {
      const auto height = static_cast<float>(base + slope.x() * column + slope.y() * row);
      heights[column] = std::max(heights[column], height);
    }
  }
}

float SunMap::sunAt(const Vec3& point, const Vec3& normal) const {
  const Vec2 cell = cellOf(point);
  const double last = height_.cols - 2;
  if (!(cell.minCoeff() >= 0.0 && cell.maxCoeff() < last)) return 1.0F;
  const double towards = std::max(kEdgeOn, normal.dot(to_sun_) / to_sun_.z());
  const double steps = normal.head<2>().norm() / towards;  // of its own height from cell to cell
  const auto limit = static_cast<float>(point.z() + kBias_m + 1.5 * kCell_m * steps);
  const int i = static_cast<int>(cell.x());
  const int j = static_cast<int>(cell.y());
  const auto a = static_cast<float>(cell.x() - i);
  const auto b = static_cast<float>(cell.y() - j);
  const auto sunny = [&](int row, int column) {
    return height_(row, column) > limit ? 0.0F : 1.0F;
  };
  return (1.0F - b) * ((1.0F - a) * sunny(j, i) + a * sunny(j, i + 1)) +
         b * ((1.0F - a) * sunny(j + 1, i) + a * sunny(j + 1, i + 1));
}

}  // namespace handmap
