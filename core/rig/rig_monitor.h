// What is going on in a rig, for whoever wants to know, and what may be asked of it: shared between
// the thread of the rig, that of the run and that of the window. All of it from any thread; nothing
// here waits.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/recording/observation.h"
#include "core/rig/device_state.h"
#include "core/rig/odometry_frames.h"
#include "core/rig/rig_clock.h"

namespace handmap {

/// The last two are no devices: they are told of the run.
enum class DeviceRole { Odometry, Scanner, Camera, Head, ToRos, ToFoxglove };
const char* nameOf(DeviceRole role);
const char* nameOf(DeviceState state);

struct DeviceStatus {
  DeviceRole role = DeviceRole::Odometry;
  DeviceState state = DeviceState::Closed;
  std::string detail;           ///< in plain words; may be empty
  std::optional<double> age_s;  ///< of the newest datum; nullopt before the first
  double rate_hz = 0.0;         ///< over the last seconds
  long count = 0;               ///< data so far
};

struct RecordingStatus {
  std::string folder;  ///< empty: it is not recorded
  int observations = 0;
  std::string error;  ///< not empty: the recording has ended with it, the run goes on
};

struct RigStatus {
  std::vector<DeviceStatus> devices;
  long given = 0;        ///< observations that the run has taken
  long passed_over = 0;  ///< by newer ones, because the run was not ready for them
  std::optional<double> observation_age_s;  ///< of the newest whole one
  std::map<std::string, long> refused;      ///< what was not used: why → how often
  std::string last_refusal;
  std::string activity;  ///< what the head is doing, may be empty
  RecordingStatus recording;
};

/// What a sensor saw last, to be looked at; not for the run.
struct RigPreview {
  long number = 0;  ///< another one: another picture
  cv::Mat left;
  cv::Mat right;
  std::vector<RangePoint> points;  ///< robot frame
};

class RigMonitor {
 public:
  explicit RigMonitor(RigClock clock = startedRigClock()) : clock_(std::move(clock)) {}

  /// A device that is silent for longer than it should counts as degraded, and says so.
  RigStatus status() const;
  RigPreview preview() const;
  double now() const { return clock_(); }
  const RigClock& clock() const { return clock_; }
  /// What the robot's own clock said at a time of the rig, seconds since 1970: that of its devices
  /// which stamp by it, of whatever the robot sees with before its odometry; else this machine's.
  double robotTime(double time_s) const;

  /// The newest of a device that measures it, in the rig's odometry frame.
  std::optional<StampedPose> odometry() const;
  /// nullopt where no device has named them.
  std::optional<OdometryFrames> frames() const;

  // To be asked of the rig.
  void end() { end_.request_stop(); }  ///< the person ends the drive: the source is at its end
  std::stop_token endToken() const { return end_.get_token(); }
  void lookAround();
  bool takeLookAround();  ///< by the rig: whether it was asked for since

  // Told by the rig and the run.
  void add(DeviceRole role);
  void setState(DeviceRole role, DeviceState state, const std::string& detail);
  void datum(DeviceRole role, double time_s);
  void moved(double time_s, const Pose2& odometry);
  void framed(const OdometryFrames& frames);
  void stamped(DeviceRole role, double time_s, double stamp_s);
  void refused(const std::string& reason, const std::string& detail = {});
  void observed(double time_s);
  void given();
  void passedOver(long observations);
  void setActivity(const std::string& words);
  void setRecording(const RecordingStatus& recording);
  void show(const cv::Mat& left, const cv::Mat& right);
  void show(const std::vector<RangePoint>& points);

 private:
  struct Watched {
    DeviceStatus status;
    double newest_s = 0.0;
    double rate_since_s = 0.0;
    long rate_count = 0;
    std::optional<double> ahead_s;  ///< the robot's clock of the rig's
  };
  Watched* find(DeviceRole role);

  RigClock clock_;
  std::stop_source end_;
  mutable std::mutex mutex_;
  std::vector<Watched> devices_;
  RigStatus status_;
  RigPreview preview_;
  std::optional<double> newest_observation_s_;
  std::optional<StampedPose> odometry_;
  std::optional<OdometryFrames> frames_;
  bool look_around_ = false;
};

}  // namespace handmap
