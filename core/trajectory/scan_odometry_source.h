// Odometry from the scans in the place of the recorded one.
#pragma once

#include <memory>

#include "core/recording/observation.h"

namespace handmap {

/// The same observations with the odometry that matching with the last scans makes of the recorded
/// one; the first keeps its own, and info().odometry is empty, since it grows with what is seen.
/// Observations without returns go on by the recorded odometry. next() throws BadInput for images
/// without range points.
std::unique_ptr<ObservationSource> withScanOdometry(std::unique_ptr<ObservationSource> source);
/// The same where nothing is recorded: the speed of before is where each match begins. Where a scan
/// does not match, that speed goes on (Observation::odometry_guessed).
std::unique_ptr<ObservationSource> withScansAlone(std::unique_ptr<ObservationSource> source);

/// The returns of all views of an observation, robot frame.
SeenPoints allPoints(const Observation& observation);

}  // namespace handmap
