// Compact things that stand alone (trees, poles): they tell how far the robot has driven.
#pragma once

#include <vector>

#include "core/estimation/walls/frame.h"

namespace handmap {

/// The middle of compact things in a frame: bearing and range as measured, robot frame. The visible
/// side of a thing moves along with the robot; its middle does not.
std::vector<Sighting> compactThings(const std::vector<FrameRay>& rays, const SensorModel& sensor);

/// Where the compact things are, map frame. A sighting names its landmark by index.
class Landmarks {
 public:
  /// Finds the landmarks of a frame's sightings; what was not seen in the last `most_frames`
  /// becomes one.
  void associate(Frame& frame, const RangeNoise& noise, std::size_t most_frames);

  std::vector<Vec2>& positions() { return positions_; }

 private:
  std::vector<Vec2> positions_;
  std::vector<std::size_t> last_seen_;  ///< number of the frame
};

}  // namespace handmap
