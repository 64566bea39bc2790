// Where what is doubted stands in the files of a recording.
#pragma once

#include <string>

#include "core/recording/recording.h"

namespace handmap {

/// "FOLDER/odometry.tum: line 12", of the pose of that time, in whichever file the odometry came
/// from. Without the line where none says so.
std::string placeOfPose(const Recording& recording, double time_s);
/// "FOLDER/frames.csv: line 12".
std::string placeOfFrame(const Recording& recording, int frame);

}  // namespace handmap
