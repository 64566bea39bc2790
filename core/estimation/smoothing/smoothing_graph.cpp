#include "core/estimation/smoothing/smoothing_graph.h"

#include <algorithm>

#include "core/estimation/smoothing/constants.h"

namespace handmap {

using namespace smoothing;

StateLayout::StateLayout(const SmoothingGraph& graph)
    : fixed_(static_cast<int>(graph.fixed)),
      boxes_(static_cast<int>(graph.frames.size() - graph.fixed) * kPoseSize),
      landmarks_(graph.landmarks.size(), kNone) {
  size_ = boxes_ + static_cast<int>(graph.boxes.size()) * kBoxSize;
  for (std::size_t b = 0; b < graph.boxes.size(); ++b) index_.emplace_back(graph.boxes[b].id, b);
  std::sort(index_.begin(), index_.end());
  std::vector<int> sightings(graph.landmarks.size());
  for (const Frame* frame : graph.frames) {
    for (const Sighting& s : frame->sightings) ++sightings[static_cast<std::size_t>(s.landmark)];
  }
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    if (sightings[i] < kLeastLooks) continue;
    landmarks_[i] = size_;
    size_ += kLandmarkSize;
  }
  bias_ = size_;
  size_ += 2 + (graph.drawing ? kMotionSize : 0);
}

int StateLayout::pose(std::size_t frame) const {
  const int free = static_cast<int>(frame) - fixed_;
  return free < 0 ? kNone : free * kPoseSize;
}

std::size_t StateLayout::indexOf(FoundId box) const {
  return std::lower_bound(index_.begin(), index_.end(), std::pair{box, std::size_t{0}})->second;
}

int StateLayout::box(std::size_t box) const { return boxes_ + static_cast<int>(box) * kBoxSize; }

}  // namespace handmap
