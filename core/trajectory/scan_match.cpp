#include "core/trajectory/scan_match.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/geometry/to_outer.h"
#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

namespace {

struct MatchEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double chance = 0.0;
  double squares = 1.0;  // as one residual more that is as the model has it
  double weights = 1.0;
  int matched = 0;

  template <typename Slope, typename Residual>
  void add(const Slope& slope, const Residual& residual, double weight) {
    information += weight * slope.transpose() * slope;
    gradient += weight * slope.transpose() * residual;
  }
};

MatchEquations linearized(const std::vector<ScanPoint>& scan, const PointMap& map,
                          const Pose2& pose, double gate_m) {
  MatchEquations sums;
  const ToOuter moved(pose);
  const std::size_t stride = scan.size() / kMostScanPoints + 1;
  for (std::size_t i = 0; i < scan.size(); i += stride) {
    const ScanPoint& p = scan[i];
    const ScanPoint outer{moved(p.at), p.straight() ? moved.turned(p.normal) : p.normal, 0.0, 0.0,
                          p.height};
    const ScanPoint* near = map.nearest(outer, gate_m);
    if (!near) continue;
    ++sums.matched;
    const double noise = p.variance + near->variance;
    const double sigma =
        std::sqrt(p.straight() ? kRough_m * kRough_m + noise / (2 * kNeighbours + 1)
                               : kPoint_m * kPoint_m + noise);
    const double chance = std::max(p.chance, near->chance);
    const double bend = (kKernelGates * gate_m / sigma) * (kKernelGates * gate_m / sigma);
    if (p.straight()) {
      const LineFactor::Value value = LineFactor{p.at, *near, sigma}.at(moved);
      const double square = value.residual * value.residual;
      const double weight = cauchyWeight(square, bend);
      sums.squares += weight * (square + p.variance / (sigma * sigma));  // of returns, not lines
      sums.weights += weight;
      sums.information += kShared * weight * value.slope.transpose() * value.slope;
      sums.gradient += kShared * weight * value.slope.transpose() * value.residual;
      sums.chance += kShared * weight * chance / (sigma * sigma);
    } else {
      const PointFactor::Value value = PointFactor{p.at, near->at, sigma}.at(moved);
      const double weight = kShared * cauchyWeight(value.residual.squaredNorm(), bend);
      sums.add(value.slope, value.residual, weight);
      sums.chance += weight * chance / (sigma * sigma);
    }
  }
  return sums;
}

void countNear(ScanMatch& match, const std::vector<ScanPoint>& scan, const PointMap& map) {
  for (const ScanPoint& p : moved(scan, match.pose)) {
    if (!p.known()) continue;
    ++match.known;
    const ScanPoint* near = map.nearest(p, 2.0 * kNear_m);
    match.near += near && std::abs(near->normal.dot(p.at - near->at)) < kNear_m;
  }
}

}  // namespace

std::optional<ScanMatch> matchScan(const std::vector<ScanPoint>& scan, const PointMap& map,
                                   const Pose2& start, std::span<const double> gates_m,
                                   const std::optional<MotionPrior>& prior) {
  ScanMatch match;
  match.pose = start;
  if (!std::ranges::any_of(scan, &ScanPoint::followed)) match.own = kTogether;
  for (const double gate_m : gates_m) {
    for (int i = 0; i < kMatchSteps; ++i) {
      MatchEquations sums = linearized(scan, map, match.pose, gate_m);
      match.information = sums.information;
      match.chance = sums.chance;
      match.misfit = sums.squares / sums.weights;
      match.matched = sums.matched;
      if (prior) {
        const Factor<3, 6> factor = prior->motion.at(prior->from, match.pose);
        sums.add(factor.jacobian.rightCols<3>(), factor.residual, 1.0);
      }
      const Eigen::LDLT<Eigen::Matrix3d> solver(sums.information);
      if (solver.info() != Eigen::Success || !solver.isPositive()) return std::nullopt;
      const Eigen::Vector3d step = -solver.solve(sums.gradient);
      if (!step.allFinite() || step.head<2>().norm() > kMostShift_m) return std::nullopt;
      match.pose = stepped(match.pose, step);
      if (step.head<2>().norm() < kStill_m && std::abs(step.z()) < kStill) break;
    }
  }
  countNear(match, scan, map);
  return match;
}

double weakerShare(const ScanMatch& match) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
      match.information.topLeftCorner<2, 2>());
  return axes.eigenvalues()(0) / axes.eigenvalues()(1);
}

std::optional<Eigen::Matrix3d> rootInformation(const ScanMatch& match,
                                               const Eigen::Vector3d& floor_sigma) {
  const Eigen::LLT<Eigen::Matrix3d> known(match.own * match.information);
  if (known.info() != Eigen::Success) return std::nullopt;
  Eigen::Matrix3d covariance = known.solve(Eigen::Matrix3d::Identity());
  covariance.diagonal() += floor_sigma.cwiseAbs2();
  return rootOf(covariance.inverse());
}

}  // namespace handmap
