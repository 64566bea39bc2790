// What a calibration says, in the words of the window.
#pragma once

#include <QString>

#include "core/calibration/board_survey.h"
#include "core/calibration/stereo_calibrator.h"

namespace handmap {

QString inWords(BoardNeed need);
/// What the person is to do now.
QString inWords(BoardVerdict verdict, const std::vector<BoardNeed>& missing);
QString inWords(const CalibrationResult& result);

}  // namespace handmap
