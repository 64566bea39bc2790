// How much a run has improved, where the truth is known.
#pragma once

#include <QString>
#include <optional>

#include "core/evaluation/comparison.h"
#include "core/method/snapshot.h"

namespace handmap {

struct RunScore {
  struct Maps {
    MeanErrors drawn;
    MeanErrors corrected;
  };
  struct Trajectories {
    TrajectoryError odometry;
    TrajectoryError corrected;
  };
  std::optional<Maps> maps;
  std::optional<Trajectories> trajectories;
};

RunScore scoreRun(const Map& drawing, const Map& refined, const std::optional<Map>& truth_map,
                  const Snapshot& last, const std::vector<StampedPose>& truth);

/// One line for the message bar; empty when nothing is known.
QString scoreInWords(const RunScore& score);
/// A table for a terminal.
QString scoreTable(const RunScore& score);

}  // namespace handmap
