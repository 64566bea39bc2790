// What a robot reports at one time, from whatever source, and the sources.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/recording/camera.h"
#include "core/recording/odometry.h"
#include "core/recording/trajectory.h"

namespace handmap {

/// Robot frame: x forward, y left, z up, metres, origin on the ground below the sensor.
struct RangePoint {
  float x;
  float y;
  float z;
  float w;  ///< 0 … 1: how surely the point is on a building
};

/// Nearer than that is the robot itself: it tells no more than that along its direction nothing was
/// measured.
inline constexpr float kOwnBody_m = 0.3F;
/// A ray that was not measured; not one along which nothing came back, which has no point.
RangePoint notMeasured(double bearing_rad, float z);
bool isMeasured(const RangePoint& point);

/// What one look in one direction gave.
struct View {
  double pan = 0.0;  ///< radians, of the camera, positive to the left
  cv::Mat left;      ///< 8 bit, one or three channels; empty where there are no images
  cv::Mat right;
  std::optional<std::vector<RangePoint>> points;  ///< in the robot frame, pan already applied
  /// One a point: of which feature it is a look, in all views; 0: of none. Empty: of none at all.
  std::vector<std::uint32_t> ids = {};
};

/// The points of several views.
struct SeenPoints {
  std::vector<RangePoint> points;
  std::vector<std::uint32_t> ids;  ///< as View has them

  /// Adds those of a view that has some.
  void add(const View& view);
};

/// A robot on the move: one view. A standing robot (stop-and-scan): the views of one stop.
struct Observation {
  int frame = 0;
  double time_s = 0.0;
  bool standing = false;
  Pose2 odometry;  ///< in the odometry frame
  /// See Odometry::guessed.
  Eigen::Matrix3d odometry_variance = Eigen::Matrix3d::Zero();
  std::vector<View> views;
  double read_ms = 0.0;  ///< time it took to get
  /// Nothing has measured the motion for so long that it is worth a word; the speed of before went
  /// on.
  bool odometry_guessed = false;
  double blind_s = 0.0;  ///< so long nothing at all told where it drove
};

/// False: the sensors were silent, and only the odometry went on.
bool seesAnything(const Observation& observation);

/// One observation could not be had; the source has moved on and can be asked for the next.
class FrameError : public std::runtime_error {
 public:
  FrameError(int frame, const std::string& message) : std::runtime_error(message), frame_(frame) {}
  int frame() const { return frame_; }

 private:
  int frame_;
};

/// So far is seen where nothing tells how far a sensor reaches.
inline constexpr double kUsualReach_m = 40.0;
/// Bounds of what is said: what is kept of the surroundings grows with the square, 0.6 GB at 200 m,
/// and no sensor that drives along streets tells walls from farther away.
inline constexpr double kLeastReach_m = 1.0;
inline constexpr double kMostReach_m = 200.0;

struct SourceInfo {
  std::string name;
  int observations = 0;                  ///< next() will give, unreadable ones too; 0: without end
  double range_limit_m = kUsualReach_m;  ///< nothing farther is measured
  std::optional<StereoCamera> camera;    ///< where views carry images
  /// Odometry at the first selected frame, whatever that frame carries: a drawing's start pose is
  /// the robot's pose there.
  Pose2 start_odometry;
  std::vector<StampedPose> odometry;  ///< the whole odometry, for drawing
  std::vector<StampedPose> truth;     ///< map frame; for scoring and drawing only, may be empty
  bool visual_odometry = false;       ///< odometry comes from the images
  bool without_odometry = false;      ///< nothing has measured it: all poses are the origin
  double speed = 0.0;  ///< times the recording's clock, where the source keeps to it; 0: it waits
};

/// Recording, simulator or live robot.
class ObservationSource {
 public:
  virtual ~ObservationSource() = default;
  virtual const SourceInfo& info() const = 0;
  /// nullopt at the end. Throws FrameError for one bad observation, Error when nothing more can
  /// come.
  virtual std::optional<Observation> next() = 0;
};

}  // namespace handmap
