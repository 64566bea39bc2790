#include "core/estimation/drawing/drawn_box.h"

#include "core/estimation/drawing/constants.h"

namespace handmap {

using namespace drawing;

DrawnBox::DrawnBox(const Rectangle& drawn, const Uncertainty& uncertainty,
                   const DrawingMotion& motion, const Box& frame) {
  const Box turned = boxOf(drawn).nearestTo(frame.heading - motion.turn());
  const double scale = motion.scale();
  const Vec2 from_origin = drawn.centre - motion.origin;
  const Vec2 centre = motion(drawn.centre) - frame.pivot;
  const auto [position, size] = uncertainty;
  const std::array<Vec2, 4> normals = frame.normals();
  covariance_.setZero();
  for (int k = 0; k < 4; ++k) {
    const auto wall = static_cast<std::size_t>(k);
    const Vec2& normal = normals[wall];
    const double half = turned.reach[wall];
    mean_[k] = normal.dot(centre) + scale * half;
    slope_.row(k) << normal.dot(from_origin) + half * motion.mean[0] / scale,
        normal.dot(perpendicular(from_origin)) + half * motion.mean[1] / scale, normal.x(),
        normal.y();
    covariance_(k, k) = position * position + size * size / 4.0;
    // Opposite normals: a shift moves the two walls apart in these coordinates.
    covariance_(k, (k + 2) % 4) = size * size / 4.0 - position * position;
  }
}

SeenWalls::SeenWalls(const FoundBox& found) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (found.reachSigma(k) < kSeen_m)
      index[static_cast<std::size_t>(count++)] = static_cast<int>(k);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (found.reachSigma(axis) < kSeen_m && found.reachSigma(axis + 2) < kSeen_m) ++widths;
  }
}

}  // namespace handmap
