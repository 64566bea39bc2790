// A building that was found, and what is known of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include <Eigen/Core>

#include "core/estimation/buildings/box.h"
#include "core/estimation/walls/frame.h"

namespace handmap {

/// Names a found building as long as a run lasts, wherever it is kept.
enum class FoundId : std::int32_t { None = -1 };

/// A building that was found: the box that explains the rays best.
struct FoundBox {
  Box box;
  double score = 0.0;  ///< log ratio against nothing there
  /// Of box.reach; large where a wall was not seen. Walls share the errors of the robot's poses.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  double heading_sigma = 0.0;
  int observations = 0;  ///< frames that saw it
  bool in_sight = true;  ///< of the last frame; others stay as they are
  /// Numbers of the frames that may have seen it.
  std::size_t first_frame = 0;
  std::size_t last_frame = std::numeric_limits<std::size_t>::max();
  /// Out of sight for long: the trajectory may have drifted since.
  bool dormant = false;
  FoundId id = FoundId::None;  ///< of its finder

  /// Whether it was found before any of the frames: there is more to know of it than they tell.
  bool predates(std::span<const Frame* const> frames) const;

  double reachSigma(std::size_t wall) const {
    const auto k = static_cast<Eigen::Index>(wall);
    return std::sqrt(covariance(k, k));
  }
  /// Of a wall that was found by other means: it shares nothing with the others.
  void setReachSigma(std::size_t wall, double sigma);
  FoundBox nearestTo(double heading_rad) const;  ///< as Box::nearestTo()
};

/// nullptr where there is none.
template <typename Boxes>
auto findBox(Boxes& boxes, FoundId id) -> decltype(&*boxes.begin()) {
  const auto at =
      std::find_if(boxes.begin(), boxes.end(), [&](const FoundBox& box) { return box.id == id; });
  return at == boxes.end() ? nullptr : &*at;
}

}  // namespace handmap
