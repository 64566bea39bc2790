// The parts of doubtsOf(). Each adds what it finds.
#pragma once

#include "core/base/median.h"
#include "core/plausibility/doubt.h"
#include "core/plausibility/places.h"
#include "core/plausibility/samples.h"

namespace handmap {

void checkTimes(const Recording& recording, Doubts& doubts);
void checkOdometry(const Recording& recording, const std::stop_token& stop, Doubts& doubts);
void checkFiles(const Recording& recording, Doubts& doubts);
void checkPoints(const Recording& recording, const std::vector<PointsSample>& samples,
                 Doubts& doubts);
/// Scans that come again though the robot has moved.
void checkFrozen(const Recording& recording, const std::stop_token& stop, Doubts& doubts);
/// Whether scans lie on each other where the odometry puts them; else how they would.
void checkAgreement(const Recording& recording, const std::stop_token& stop, Doubts& doubts);

/// Whether the headings are those of the way in degrees, taken for radians.
bool lookLikeDegrees(const std::vector<StampedPose>& poses);

/// Metres a unit of the odometry, 0.01 or 0.001, as the scans lie on each other the better; nullopt
/// where there are too few.
std::optional<double> scaleByScans(const Recording& recording, const std::stop_token& stop);

/// What the odometry is likely counted in, `scale` metres a unit: 0.01 or 0.001. With the remedy.
void sayUnitOfOdometry(double scale, Doubt& doubt);

}  // namespace handmap
