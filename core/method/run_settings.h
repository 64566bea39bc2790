// What a run is asked to do.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/fastslam/slam_options.h"
#include "core/perception/perception.h"
#include "core/recording/trajectory.h"

namespace handmap {

class SeenPlace;

/// Paper: FastSLAM/PSOM as published. Handmap: ours.
enum class Method { Handmap, Paper };

struct RunSettings {
  Method method = Method::Handmap;
  SlamOptions slam;
  PerceptionOptions perception;
  bool free_scale = false;  ///< the drawing as a whole may have another scale
  bool free_turn = false;   ///< or be turned; Method::Handmap
  std::uint64_t seed = 1;
  int threads = 0;                    ///< 0: as many as the machine has
  bool conclude_on_the_way = false;   ///< as at the end, now and then, to be shown; Method::Handmap
  std::string odometry = "recorded";  ///< what the source's odometry comes from, for the report
  /// Where somebody says that the robot was; increasing in time, map frame. See GivenPoses.
  std::vector<StampedPose> given_poses = {};
  /// Of a robot that has driven before: what was seen then where this run is said to begin.
  std::shared_ptr<const SeenPlace> seen_at_start = {};
};

}  // namespace handmap
