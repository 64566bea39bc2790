// What went wrong without ending a run, told by its outcome.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/map/map.h"
#include "core/method/run_warning.h"
#include "core/method/snapshot.h"
#include "core/perception/perception.h"
#include "core/recording/trajectory.h"

namespace handmap {

/// What a run has looked at, added up over its observations.
struct RunCounts {
  int observations = 0;
  int with_building = 0;              ///< observations with a building in sight
  bool images = false;                ///< seen by cameras, not by ranges
  std::size_t points = 0;             ///< ranges that came back, of a range sensor
  std::size_t walls = 0;              ///< directions in which something was taken for a wall
  double farthest_m = 0.0;            ///< of the walls
  int guessed = 0;                    ///< observations whose motion nothing told
  double guessed_s = 0.0;             ///< the time of the first of them
  double unrecognised_m = 0.0;        ///< the most of FrameReport's
  double unrecognised_until_s = 0.0;  ///< the time of that
  bool start_refuted = false;         ///< see FrameReport

  void add(const Percept& percept, const FrameReport& report);
};

/// What the warnings are drawn from; `trajectory` and `refined` as at the end of the run.
struct RunOutcome {
  const RunCounts& counts;
  double range_limit_m;
  const Map& drawing;
  const Map& refined;
  const std::vector<StampedPose>& trajectory;
  bool refine;                            ///< buildings were to be corrected
  double unrecognised_m = 0.0;            ///< at the end, see Recognition
  std::optional<Pose2> drawn_start = {};  ///< where given poses told another one for `drawing`
  std::vector<RunWarning> of_method = {};
};

/// Those of the method, then at most one of the codes nothing_recognised, nothing_corrected,
/// way_from_odometry, end_unrecognised and part_unrecognised: the first that holds says what
/// follows from it too; nothing_corrected is left out where the method says why
/// (buildings_dropped). And motion_guessed, began_elsewhere and start_moved.
std::vector<RunWarning> runWarnings(const RunOutcome& outcome);

}  // namespace handmap
