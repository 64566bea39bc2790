// What a run shows after an observation. Immutable once made; shared between threads.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/lazy.h"
#include "core/base/shared_list.h"
#include "core/map/map.h"
#include "core/method/constants.h"
#include "core/perception/local_map.h"
#include "core/recording/trajectory.h"
#include "core/tape/panning.h"
#include "core/tape/past_sight.h"

namespace handmap {

struct Phase;

struct ParticleView {
  Pose2 pose;
  double weight = 0.0;  ///< normalized: the sum over the particles is 1
};

/// Samples of what a building near the robot may be.
struct SwarmView {
  std::size_t building;  ///< of the drawing
  std::vector<Polygon> members;
};

/// Milliseconds of one observation, by stage; the same stages as in --report.
struct StageTimes {
  double read = 0.0;
  double stereo = 0.0;
  double classify = 0.0;
  double local_map = 0.0;
  double slam = 0.0;
  double total = 0.0;
};

struct FrameReport {
  int frame = 0;
  double time_s = 0.0;
  StageTimes ms;
  double effective_sample_size = 0.0;
  int visible_buildings = 0;
  Pose2 pose;
  std::array<double, 3> pose_sigma{};  ///< x, y in metres, heading in radians
  double pose_xy = 0.0;                ///< covariance of x and y, square metres
  /// Probability that the pose is off by no more than method::kWithin_m.
  std::array<double, method::kWithin_m.size()> within{};
  bool odometry_guessed = false;  ///< see Observation
  /// Of the observation, nats: by the published method that of its particles, by ours how much
  /// better the buildings in sight explain what was seen than nothing does. Absent: not known.
  std::optional<double> log_likelihood;
  int loops = 0;                ///< closed so far
  double unrecognised_m = 0.0;  ///< see Recognition
  bool start_refuted = false;   ///< see SeenPlace; and nobody has said since where it is
};

struct Snapshot {
  int index = 0;  ///< observations done
  int count = 0;  ///< observations in all
  FrameReport report;
  std::vector<ParticleView> particles;
  std::vector<SwarmView> swarms;
  /// Best so far, ready to be saved: with the "refinement" object; every refined building has its
  /// estimate.
  Lazy<Map> map;
  SharedList<StampedPose> trajectory;  ///< best so far, map frame
  SharedList<StampedPose> odometry;    ///< alone, from the same start
  Pose2 driven;                        ///< odometry of the observation, in its own frame
  std::optional<Pose2> truth;          ///< for drawing; never read by the estimator
  LazyLocalMap local_map;              ///< around report.pose
  cv::Mat image;                       ///< left image, not to be written to; empty without a camera
  cv::Mat1f disparity;                 ///< the same
  cv::Mat1f buildings;  ///< probability of each of its 16×16 windows, see StereoResult
  int pictured = 0;     ///< the frame that these three are of; an earlier one where it was long ago
  Panning panning;      ///< of the three
  PastSight seen;       ///< what the sensors saw
  /// How the method came to it, where that was asked for.
  std::shared_ptr<const std::vector<Phase>> phases;
};

}  // namespace handmap
