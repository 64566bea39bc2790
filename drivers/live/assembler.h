// Puts together what the devices of a rig tell: an observation is whole when its pose is known. No
// clock, no thread: who calls it says what time it is. Seconds of the rig's clock.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "core/recording/observation.h"
#include "core/rig/rig.h"
#include "drivers/live/odometry_track.h"
#include "drivers/live/stop_scan.h"

namespace handmap {

/// Of what a scanner gives, what can be used.
std::vector<RangePoint> inRobotFrame(const std::vector<RangePoint>& points,
                                     const ScannerMount& mount);

class Assembler {
 public:
  struct Sinks {
    std::function<void(Observation)> whole;  ///< views as the camera gives them, not rectified
    std::function<void(double pan)> look;    ///< drive the head there
    std::function<void(const std::string& reason)> refused;  ///< something was not used
  };
  Assembler(const Rig& rig, Sinks sinks);

  void moved(double time_s, const Pose2& pose, double now_s);
  void scanned(double time_s, const std::vector<RangePoint>& points, double now_s);
  void pairTaken(double time_s, const cv::Mat& left, const cv::Mat& right, double now_s);
  void headArrived(double pan, double now_s);
  void headLost();
  /// A person asks for a look around.
  void lookAround();
  /// A few times a second: gives up on what does not come.
  void tick(double now_s);

  std::string activity() const { return stops_ ? stops_->describe() : std::string(); }

 private:
  using Word = std::string (*)();  ///< said only where something is wrong
  bool isTimely(double time_s, double& newest_s, double now_s, Word what);
  struct Waiting {
    double time_s;
    View view;
  };
  void addMoving(double time_s, View view);
  Waiting takeWaiting();
  bool isFrozen(const View& view, const Pose2& pose);
  void settle(double now_s);
  void goOnBlind(double now_s);
  void deliver(double time_s, const Pose2& pose, bool standing, std::vector<View> views);
  void act(std::optional<StopScan::Action> action);

  Rig rig_;
  Sinks sinks_;
  OdometryTrack odometry_;
  std::optional<StopScan> stops_;
  double newest_odometry_s_ = -1.0;
  double newest_view_s_ = -1.0;
  std::deque<Waiting> waiting_;  ///< for their odometry
  std::size_t waiting_bytes_ = 0;
  std::vector<RangePoint> newest_points_;
  Pose2 newest_points_from_;  ///< where they came first
  std::vector<View> stop_views_;
  double stop_time_s_ = 0.0;  ///< of the first of them
  double delivered_s_ = -1.0;
  double blind_at_s_ = 0.0;  ///< unless something is seen before
  int frame_ = 0;
};

}  // namespace handmap
