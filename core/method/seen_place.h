// What an earlier drive saw around a place: it refutes that a robot which sees something else
// stands there.
#pragma once

#include <optional>
#include <vector>

#include "core/base/shared_list.h"
#include "core/tape/tape.h"
#include "core/trajectory/scan_features.h"

namespace handmap {

class SeenPlace {
 public:
  /// `way`: of all observations of the tape that were not skipped; it and `at` are in the map's
  /// frame. Some tens of reads of the tape.
  SeenPlace(const Tape& tape, const SharedList<StampedPose>& way, const Pose2& at);

  /// Whether this is seen elsewhere than a few metres around there. False where either has too few
  /// straight walls to tell.
  bool isRefutedBy(const std::vector<RangePoint>& points, double range_limit_m) const;

 private:
  /// Of the straight walls of a look, those that the looks but one saw, too. nullopt: too few.
  std::optional<double> shareSeen(const std::vector<ScanPoint>& now,
                                  const std::vector<ScanPoint>* left_out) const;

  std::vector<std::vector<ScanPoint>> looks_;  ///< frame of the place
};

}  // namespace handmap
