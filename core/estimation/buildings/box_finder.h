// Buildings from walls and rays, without the drawing.
#pragma once

#include <span>
#include <vector>

#include "core/estimation/buildings/box_score.h"
#include "core/estimation/buildings/found_box.h"
#include "core/estimation/walls/wall_detection.h"

namespace handmap {

/// Keeps a list of buildings up to date with walls detected in the evidence and with the rays
/// themselves.
class BoxFinder {
 public:
  /// Refines the boxes that the last frame looks at. `frames`: the last ones, back to those that
  /// saw the first of what is in sight.
  void refineAll(std::vector<FoundBox>& boxes, std::span<const Frame* const> frames,
                 const SensorModel& sensor);
  /// Changes and drops boxes in sight and adds new ones.
  void update(std::vector<FoundBox>& boxes, const std::vector<FoundWall>& walls,
              std::span<const Frame* const> frames, const SensorModel& sensor);
  /// Finds the walls that no returns are from (rear walls, behind which there is free space) where
  /// the rays tell them, and says how well they are known.
  void locateUnseen(FoundBox& found, std::span<const Frame* const> frames,
                    const SensorModel& sensor) const;

 private:
  /// Local search of the box that explains the rays best; `step_m` is how far it looks at first.
  void refine(FoundBox& found, double step_m, std::span<const Frame* const> frames,
              const SensorModel& sensor) const;
  /// Of boxes that cannot both be the surer stays. The other one comes back when that is given up.
  void prune(std::vector<FoundBox>& boxes);
  double objective(const Box& box, BoxScorer& scorer) const;
  bool adopt(FoundBox& found, const FoundWall& wall, std::span<const Frame* const> frames,
             const SensorModel& sensor) const;
  /// The pieces of a box whose walls were found apart, where they explain the rays better.
  std::vector<FoundBox> split(const FoundBox& found, const std::vector<FoundWall>& walls,
                              std::span<const Frame* const> frames,
                              const SensorModel& sensor) const;
  Box seed(const FoundWall& wall) const;
  FoundId newId() { return static_cast<FoundId>(found_so_far_++); }

  std::int32_t found_so_far_ = 0;
  std::vector<FoundBox> rivals_;  ///< where a surer box stands
};

}  // namespace handmap
