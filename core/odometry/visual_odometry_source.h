// Visual odometry in the place of wheels: for recordings that have images and no odometry.
#pragma once

#include <memory>

#include "core/recording/recording.h"

namespace handmap {

/// What becomes of a motion that nothing has told for longer than 3 s.
enum class WhenLost {
  Throw,      ///< next() throws RunFailed: who replays can give another odometry
  StandStill  ///< the robot is taken to stand until it sees again: a live run goes on
};

/// The same observations with the odometry that their images tell, from the origin at the first
/// one; info().odometry is empty, since it grows with what is seen. Of several views (a stop) the
/// one that looks ahead most is used. It sees only the observations that the source gives: with
/// --every N that is each Nth, and what is too far apart cannot be matched. Where nothing tells the
/// motion, the speed of before is believed for 3 s (Observation::odometry_guessed); after that, and
/// at once between stops, `when_lost` counts. Throws BadInput for a source without a camera.
std::unique_ptr<ObservationSource> withVisualOdometry(std::unique_ptr<ObservationSource> source,
                                                      WhenLost when_lost = WhenLost::Throw);

/// replay(); with visual odometry where the options ask for it, or where there are images and no
/// odometry.
std::unique_ptr<ObservationSource> replayWithOdometry(Recording recording, ReplayOptions options);

}  // namespace handmap
