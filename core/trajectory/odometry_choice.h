// Which odometry a recording is replayed with.
#pragma once

#include <memory>
#include <string>

#include "core/recording/recording.h"

namespace handmap {

/// Recorded: the recording's own or a file's (where there is none, visual or, of a range sensor,
/// scan). Auto: the one that makes
/// what the range sensor saw the sharpest.
enum class OdometryKind { Recorded, Visual, Scan, Auto };

/// As on the command line: "recorded", "visual", "scan", "auto".
std::string nameOf(OdometryKind kind);

struct ChosenOdometry {
  std::unique_ptr<ObservationSource> source;
  OdometryKind kind = OdometryKind::Recorded;  ///< never Auto
  std::string reason;  ///< of Auto, one line: what was compared and how it came out
};

/// Auto reads all range points first, some milliseconds an observation, and all images where there
/// are some as well. It leaves the recorded odometry only for one that is clearly sharper; without
/// range points there is nothing to compare. Throws BadInput as replay() does, and for Visual
/// without images or Scan without range points.
ChosenOdometry replayWithOdometry(Recording recording, ReplayOptions options, OdometryKind kind);

}  // namespace handmap
