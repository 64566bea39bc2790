// A robot that stands looks around: the head is driven from pan to pan, and at each one pair of
// images is taken after it has arrived. A state machine without clock, device or thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/rig/rig.h"

namespace handmap {

class StopScan {
 public:
  /// What is to be done now.
  struct Action {
    enum class Kind {
      Look,     ///< drive the head to `pan`
      Take,     ///< the pair that was just told is the view at `pan`
      Deliver,  ///< all views are there: they are one observation, taken at `pose`
      Drop      ///< forget the views, `reason` says why; the head looks ahead again (`pan`)
    };
    Kind kind;
    double pan = 0.0;  ///< radians, of Look, Take and Drop
    Pose2 pose = {};   ///< odometry frame, of Deliver
    std::string reason = {};
  };

  explicit StopScan(StopRig options) : options_(std::move(options)) {}

  // Each tells something and gives what follows from it. Seconds of the rig's clock.
  std::optional<Action> moved(double time_s, const Pose2& pose, double standing_for_s);
  std::optional<Action> arrived(double time_s, double pan);
  std::optional<Action> pairTaken(double time_s);
  std::optional<Action> headLost();
  /// Now and then, for what did not come.
  std::optional<Action> tick(double now_s);
  /// A person asks for a look around; it begins as soon as the robot stands.
  void trigger();

  bool isLooking() const { return state_ != State::Waiting; }
  /// In words, for a person.
  std::string describe() const;

 private:
  enum class State { Waiting, Turning, Taking, Taken };
  Action begin(double now_s);
  std::optional<Action> lookWithoutWheels(double now_s);
  Action look(double now_s);
  Action drop(const std::string& reason);
  double pan() const { return options_.pans[next_]; }

  StopRig options_;
  State state_ = State::Waiting;
  std::size_t next_ = 0;            ///< of the pans
  double since_s_ = 0.0;            ///< in this state
  double now_s_ = 0.0;              ///< the latest time that was told
  Pose2 pose_;                      ///< where it stands
  std::optional<Pose2> looked_at_;  ///< where it looked around last
  bool wanted_ = false;
  bool by_person_ = false;                ///< this look around was asked for
  std::string missed_;                    ///< why it is of no use; empty: it is
  std::optional<double> wanted_since_s_;  ///< as far as tick() has seen
  bool has_moved_ = false;                ///< odometry was told since it was asked for
};

}  // namespace handmap
