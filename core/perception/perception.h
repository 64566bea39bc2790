// From an observation to walls and a scan: the pipeline of section II.
#pragma once

#include <optional>
#include <stop_token>

#include "core/odometry/stereo_odometry.h"
#include "core/perception/joined_frames.h"
#include "core/perception/local_map.h"
#include "core/perception/range_walls.h"
#include "core/perception/scan.h"
#include "core/perception/stereo_walls.h"

namespace handmap {

struct PerceptionOptions {
  StereoOptions stereo;
  WallFilter points;  ///< for range points
  LocalMapOptions local_map;
  bool classify = true;  ///< tell buildings from the rest in images
  /// nullptr: the ones that come with the program.
  std::shared_ptr<const WindowClassifier> classifier;
};

struct Percept {
  std::vector<WallPoint> walls;    ///< of this observation alone, for a local map
  Scan scan;                       ///< of this observation alone
  std::vector<RangePoint> points;  ///< of all views, as they came; empty with images
  std::vector<std::uint32_t> ids;  ///< as View::ids, of the points
  /// They were put together from several frames by the odometry; the repeats are taken out.
  bool joined = false;
  /// How the robot moved since the observation before, in its frame there, as images tell it;
  /// nullopt where they do not.
  std::optional<Pose2> moved = {};
  cv::Mat image;        ///< left image of the last view, empty without images
  cv::Mat1f disparity;  ///< of the last view
  cv::Mat1f buildings;  ///< as StereoResult, of the last view
  double stereo_ms = 0.0;
  double classify_ms = 0.0;
};

class Perception {
 public:
  Perception(const SourceInfo& source, const PerceptionOptions& options);

  /// nullopt when `stop` was requested. Throws BadInput for a view that cannot be used (sizes,
  /// channels): the frame is then skipped.
  std::optional<Percept> operator()(const Observation& observation,
                                    const std::stop_token& stop = {});

 private:
  std::optional<Pose2> motionTo(const Observation& observation);

  double range_limit_m_;
  double camera_yaw_ = 0.0;  ///< radians
  std::optional<StereoWalls> stereo_;
  std::optional<StereoOdometry> odometry_;  ///< not where the odometry is of images already
  Pose2 at_;                                ///< by odometry, the observation before
  bool followed_ = false;                   ///< images told the motion to it
  JoinedFrames joined_;
  RangeWalls range_walls_;
  ScanBuilder scans_;
};

}  // namespace handmap
