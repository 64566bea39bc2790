#include "core/estimation/smoothing/prior_factors.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/estimation/buildings/constants.h"
#include "core/estimation/smoothing/constants.h"
#include "core/perception/constants.h"

namespace handmap {

using namespace smoothing;

ScalarFactor<1> headingFactor(const Box& box, const HeadingPrior& prior) {
  double turned = 0.0;
  double sigma = kUnknownHeading;
  for (const double heading : prior.headings) {
    const double against = std::remainder(box.heading - heading, kPi / 2.0);
    if (sigma == prior.sigma && std::abs(against) > std::abs(turned)) continue;
    turned = against;
    sigma = prior.sigma;
  }
  const double most = kRobust * sigma;
  return {std::clamp(turned, -most, most), Eigen::Matrix<double, 1, 1>::Ones(),
          1.0 / (sigma * sigma)};
}

void addReachDamping(int box_at, NormalEquations& equations) {
  const double size = 1.0 / (kSizeDamping_m * kSizeDamping_m);
  const double place = 0.25 / (kPlaceDamping_m * kPlaceDamping_m);
  for (int k = 0; k < 2; ++k) {
    equations.add(box_at + k, box_at + k, size + place);
    equations.add(box_at + k + 2, box_at + k + 2, size + place);
    equations.add(box_at + k + 2, box_at + k, size - place);
  }
}

void addKnownWalls(const FoundBox& found, int box_at, NormalEquations& equations) {
  for (int k = 0; k < 4; ++k) {
    const double sigma =
        std::max(found.reachSigma(static_cast<std::size_t>(k)), buildings::kFloor_m);
    equations.add(box_at + k, box_at + k, 1.0 / (sigma * sigma));
  }
}

void addSame(const FoundBox& old, const FoundBox& again, int old_at, int again_at,
             NormalEquations& equations) {
  for (const SharedParameter& parameter : compare(old, again)) {
    const double sigma = parameter.old_parameter < 4 ? perception::kWall_m : kSameHeading;
    ScalarFactor<2 * kBoxSize> factor;
    factor.residual = parameter.error;
    factor.slope << parameter.old_slope, parameter.again_slope;
    factor.weight = 1.0 / (sigma * sigma);
    equations.add(factor, std::array{NormalEquations::Unknowns{old_at, kBoxSize},
                                     NormalEquations::Unknowns{again_at, kBoxSize}});
  }
}

DrawnWallsFactor drawnWallsFactor(const FoundBox& found, const SeenWalls& seen,
                                  const DrawingPrior::Anchor& anchor, const DrawingMotion& motion) {
  const DrawnBox drawn(anchor.drawn->box(), anchor.uncertainty, motion, found.box);
  // Walls that were not seen may be anywhere.
  Eigen::Matrix4d covariance = kTogether * kTogether * drawn.covariance();
  for (Eigen::Index k = 0; k < 4; ++k) {
    if (!seen.has(k)) covariance(k, k) += kNowhere_m2;
  }
  DrawnWallsFactor factor;
  factor.weight = covariance.inverse();
  factor.residual = Eigen::Map<const Eigen::Vector4d>(found.box.reach.data()) - drawn.mean();
  factor.by_motion = drawn.slope();
  // Cauchy's weight.
  factor.weight /=
      1.0 + factor.residual.dot(factor.weight * factor.residual) / (kRobust * kRobust * seen.count);
  return factor;
}

void addDrawing(const SmoothingGraph& graph, const StateLayout& layout,
                NormalEquations& equations) {
  const DrawingPrior& drawing = *graph.drawing;
  const int motion_at = layout.motion();
  const Eigen::Matrix4d prior = drawing.expected.covariance.inverse();
  equations.addBlock(motion_at, motion_at, prior);
  equations.right({motion_at, kMotionSize}) -=
      prior * (drawing.motion.mean - drawing.expected.mean);
  for (const DrawingPrior::Anchor& anchor : drawing.anchors) {
    const std::size_t box = layout.indexOf(anchor.box);
    const FoundBox& found = graph.boxes[box];
    const SeenWalls seen(found);
    if (seen.count == 0) continue;
    const DrawnWallsFactor factor = drawnWallsFactor(found, seen, anchor, drawing.motion);
    const int box_at = layout.box(box);
    const Eigen::Matrix4d across = factor.by_motion.transpose() * factor.weight;
    equations.addBlock(box_at, box_at, factor.weight);
    equations.addBlock(motion_at, box_at, -across);
    equations.addBlock(motion_at, motion_at, Eigen::Matrix4d(across * factor.by_motion));
    equations.right({box_at, 4}) -= factor.weight * factor.residual;
    equations.right({motion_at, kMotionSize}) += across * factor.residual;
  }
}

}  // namespace handmap
