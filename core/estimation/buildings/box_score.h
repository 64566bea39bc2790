// How well a box explains what was seen: the exact sum over rays.
#pragma once

#include <span>
#include <vector>

#include "core/estimation/buildings/box_view.h"

namespace handmap {

/// Scores boxes near a given one: finds once which frames and rays can meet them.
class BoxScorer {
 public:
  /// Looks at each `stride`-th ray: two take half the time for √2 of the noise.
  BoxScorer(const Box& box, std::span<const Frame* const> frames, const SensorModel& sensor,
            std::size_t stride = buildings::kStride);

  /// Sum of the log likelihood ratios of all rays that would meet the box; very low where a robot
  /// stands inside it. The box may be any: far from the one given it only takes longer.
  double operator()(const Box& box);

 private:
  struct Looking {
    const Frame* frame;
    RayStretches rays;  ///< that can meet the boxes
    PoseAtBox pose;
  };
  void lookAt(const Box& box);
  void turnTo(const Box& box);

  std::span<const Frame* const> frames_;
  const SensorModel& sensor_;
  std::size_t stride_;
  std::array<Vec2, 4> around_;  ///< corners of the box that the rays are around
  Pose2 turned_to_;             ///< the frame of a box that the poses are in
  std::vector<Looking> looking_;
};

}  // namespace handmap
