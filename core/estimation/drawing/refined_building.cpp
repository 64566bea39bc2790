#include "core/estimation/drawing/refined_building.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/estimation/drawing/constants.h"

namespace handmap {

using namespace drawing;

namespace {

/// Takes over the walls that were seen, the least surprising first. One that the drawing and the
/// others make very unlikely is of something built on to the building.
void correct(const FoundBox& found, DrawnBox::Walls& walls, DrawnBox::Covariance& covariance) {
  // Walls and, because they share them, the errors of what was found: z = wall + error.
  using State = Eigen::Matrix<double, 8, 1>;
  State state;
  state << walls, Eigen::Vector4d::Zero();
  Eigen::Matrix<double, 8, 8> spread = Eigen::Matrix<double, 8, 8>::Zero();
  spread.topLeftCorner<4, 4>() = covariance;
  spread.bottomRightCorner<4, 4>() = found.covariance;
  const SeenWalls seen(found);
  std::vector<int> left(seen.index.begin(), seen.index.begin() + seen.count);
  while (!left.empty()) {
    const auto shared = [&](int k) -> State { return spread.col(k) + spread.col(4 + k); };
    const auto variance = [&](int k) { return shared(k)[k] + shared(k)[4 + k]; };
    const auto error = [&](int k) {
      return found.box.reach[static_cast<std::size_t>(k)] - state[k] - state[4 + k];
    };
    const auto surprise = [&](int k) { return std::abs(error(k)) / std::sqrt(variance(k)); };
    const auto next = std::min_element(left.begin(), left.end(),
                                       [&](int a, int b) { return surprise(a) < surprise(b); });
    if (surprise(*next) > kUnlikely) break;
    const State with = shared(*next);
    const double of = variance(*next);
    state += with * (error(*next) / of);
    spread -= with * with.transpose() / of;
    left.erase(next);
  }
  walls = state.head<4>();
  covariance = spread.topLeftCorner<4, 4>();
}

}  // namespace

RefinedBuilding refinedBuilding(const Building& building, const Uncertainty& uncertainty,
                                const DrawingMotion& motion, const FoundBox* found) {
  const Rectangle drawn = building.box();
  Box frame{motion(drawn.centre), drawn.heading + motion.turn(), {}};
  if (found) {
    // Keeps the sides in the order of the drawing.
    const double heading = frame.heading;
    frame = found->box.nearestTo(heading);
  }
  const DrawnBox prior(building.box(), uncertainty, motion, frame);
  DrawnBox::Walls walls = prior.mean();
  DrawnBox::Covariance covariance =
      prior.covariance() + prior.slope() * motion.covariance * prior.slope().transpose();
  int observations = 0;
  if (found) {
    const FoundBox turned = found->nearestTo(frame.heading);
    correct(turned, walls, covariance);
    observations = found->observations;
  }
  for (int axis = 0; axis < 2; ++axis) {
    const double size = axis == 0 ? drawn.width : drawn.depth;
    const double least = kLeastKept * motion.scale() * size;
    const double missing = least - (walls[axis] + walls[axis + 2]);
    if (missing <= 0.0) continue;
    // What was seen stays; the other wall gives way.
    const int wall = covariance(axis, axis) > covariance(axis + 2, axis + 2) ? axis : axis + 2;
    walls[wall] += missing;
  }
  Box box = frame;
  for (int k = 0; k < 4; ++k) box.reach[static_cast<std::size_t>(k)] = walls[k];
  const auto variance = [&](int axis, double sign) {
    return std::max(0.0, covariance(axis, axis) + covariance(axis + 2, axis + 2) +
                             2.0 * sign * covariance(axis, axis + 2));
  };
  const double u = variance(0, -1.0) / 4.0;
  const double v = variance(1, -1.0) / 4.0;
  const double c = std::pow(std::cos(frame.heading), 2);
  RefinedBuilding refined;
  refined.walls = box;
  refined.covariance = covariance;
  refined.estimate = {std::sqrt(c * u + (1.0 - c) * v), std::sqrt((1.0 - c) * u + c * v),
                      std::sqrt(variance(0, 1.0)), observations};
  return refined;
}

}  // namespace handmap
