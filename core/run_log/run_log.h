// Writes a run as MCAP with messages of ROS 2, for the programs that show such: RViz 2, Foxglove,
// Lichtblick, PlotJuggler, Rerun.
//
// Frames: map (x right, y up) and base_link, the robot. What is large (the drawing as corrected,
// the grid around the robot) is written once a second.
#pragma once

#include <filesystem>
#include <memory>

#include "core/method/snapshot.h"
#include "core/session/run_session.h"
#include "core/session/run_warnings.h"

namespace handmap {

class RunLog {
 public:
  /// It is runPartOf(path) until finish(), and whole at any time. Throws RunFailed, as the others
  /// do.
  RunLog(const std::filesystem::path& path, const Map& drawing, const SourceInfo& source);
  ~RunLog();
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;

  /// Of each frame once: what comes again is passed over.
  void add(const Snapshot& snapshot);
  /// With what the run came to: map, way, warnings, and how to make it again.
  void finish(const Map& refined, const std::vector<StampedPose>& trajectory,
              const std::vector<RunWarning>& warnings);

 private:
  struct Topics;
  std::unique_ptr<Topics> topics_;
};

}  // namespace handmap
