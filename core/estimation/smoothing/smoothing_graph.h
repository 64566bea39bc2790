// What is smoothed together, and where each of its states stands among the unknowns.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/estimation/drawing/drawing_prior.h"
#include "core/estimation/loops/same_building.h"
#include "core/estimation/smoothing/constants.h"

namespace handmap {

struct SmoothingGraph {
  std::span<Frame* const> frames;  ///< in order of time; consecutive ones are bound by odometry
  std::size_t fixed = 1;           ///< poses before this one stay
  std::span<FoundBox> boxes;
  std::vector<Vec2>& landmarks;
  std::span<const SameBuilding> same = {};  ///< of the boxes
  DrawingPrior* drawing = nullptr;          ///< its motion follows
};

/// Positions in the vector of unknowns: poses, boxes, landmarks, the bias of the ranges, the scale
/// of the odometry, the motion of the drawing.
class StateLayout {
 public:
  StateLayout() = default;
  explicit StateLayout(const SmoothingGraph& graph);

  int size() const { return size_; }
  /// smoothing::kNone where it stays.
  int pose(std::size_t frame) const;
  int lastPose() const { return boxes_ == 0 ? smoothing::kNone : boxes_ - smoothing::kPoseSize; }
  int box(std::size_t box) const;
  /// Which of the boxes one is.
  std::size_t indexOf(FoundId box) const;
  /// smoothing::kNone where too few frames saw it.
  int landmark(std::size_t landmark) const { return landmarks_[landmark]; }
  int bias() const { return bias_; }
  int scale() const { return bias_ + 1; }
  int motion() const { return bias_ + 2; }

 private:
  int fixed_ = 0;
  int boxes_ = 0;
  std::vector<std::pair<FoundId, std::size_t>> index_;  ///< of the boxes, by id
  std::vector<int> landmarks_;
  int bias_ = 0;
  int size_ = 0;
};

}  // namespace handmap
