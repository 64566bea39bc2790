// What whoever navigates by a run has to know of it at a moment.
#pragma once

#include <string>
#include <vector>

#include "core/method/pose_trust.h"
#include "core/rig/rig.h"
#include "core/rig/rig_monitor.h"

namespace handmap {

/// Lost also where nothing was heard of the robot for two seconds, and when the drive has ended.
Certainty stateNow(const Snapshot* newest, const Rig& rig, const RigMonitor& monitor);

const char* nameOf(Certainty state);
/// In plain words, of what stateNow() says.
std::string whyNow(Certainty state, const Snapshot* newest, const RigMonitor& monitor);

/// Where a frame lies in another one.
struct FrameLink {
  std::string parent;
  std::string child;
  Pose2 pose;
};
/// As REP 105 has it: the odometry frame on the map, so that the odometry stays continuous.
/// `driven`: the odometry at the moment that it is told for; not nullptr: the robot in it as well,
/// where the robot does not tell that itself.
std::vector<FrameLink> linksOf(const Snapshot& newest, const RigMonitor& monitor,
                               const Pose2* driven);

}  // namespace handmap
