// Poses sampled from odometry (Algorithm 1, first line of the loop).
#pragma once

#include "core/base/random.h"
#include "core/fastslam/slam_options.h"
#include "core/geometry/pose2.h"

namespace handmap {

/// `pose` after the odometry step `motion` (in the frame of the pose before), with the noise of the
/// model: the turn is disturbed before and after the way, the way in its length.
Pose2 samplePose(const Pose2& pose, const Pose2& motion, const MotionNoise& noise,
                 RandomStream& random);

/// A motion that was guessed, somewhere within `variance` of it: see guessedOf().
Pose2 sampleGuess(const Pose2& motion, const Eigen::Matrix3d& variance, RandomStream& random);

}  // namespace handmap
