// Slopes by central differences, to check those that are written out.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "core/estimation/buildings/box.h"
#include "core/geometry/pose2.h"

namespace handmap {

/// Adds to one of the unknowns of a factor.
using Change = std::function<void(double)>;

/// The unknowns of a pose and of a box, in the order of the factors.
inline std::vector<Change> unknownsOf(Pose2& pose) {
  return {[&](double by) { pose.x += by; }, [&](double by) { pose.y += by; },
          [&](double by) { pose.heading += by; }};
}
inline std::vector<Change> unknownsOf(Box& box) {
  std::vector<Change> unknowns;
  for (double& reach : box.reach) unknowns.push_back([&reach](double by) { reach += by; });
  unknowns.push_back([&](double by) { box.heading += by; });
  return unknowns;
}
inline Change unknown(double& value) {
  return [&](double by) { value += by; };
}

/// The columns of `jacobian` against the differences of `residual()`, which gives a vector.
template <typename Jacobian, typename Residual>
void expectSlopes(const Jacobian& jacobian, const std::vector<Change>& unknowns,
                  const Residual& residual, double tolerance = 1e-6) {
  constexpr double kStep = 1e-5;
  ASSERT_EQ(static_cast<std::size_t>(jacobian.cols()), unknowns.size());
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    unknowns[i](kStep);
    const Eigen::VectorXd above = residual();
    unknowns[i](-2.0 * kStep);
    const Eigen::VectorXd below = residual();
    unknowns[i](kStep);
    const Eigen::VectorXd slope = (above - below) / (2.0 * kStep);
    for (Eigen::Index row = 0; row < slope.size(); ++row) {
      EXPECT_NEAR(jacobian(row, static_cast<Eigen::Index>(i)), slope[row], tolerance)
          << "residual " << row << ", unknown " << i;
    }
  }
}

template <typename Vector>
void append(std::vector<Vector>& to, const std::vector<Vector>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace handmap
