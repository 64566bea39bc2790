// A checkerboard before live cameras: pairs of images come in, those worth it are taken.
#pragma once

#include <filesystem>
#include <optional>

#include "core/calibration/board_images.h"
#include "core/calibration/board_survey.h"
#include "core/calibration/stereo_calibrator.h"

namespace handmap {

/// What was seen last, and what is there so far.
struct CaptureStatus {
  long looks = 0;
  cv::Mat left;  ///< as it came
  cv::Mat right;
  std::vector<cv::Point2f> left_corners;  ///< empty: not the whole board
  std::vector<cv::Point2f> right_corners;
  BoardVerdict verdict = BoardVerdict::NotSeen;
  int taken = 0;
  std::vector<BoardNeed> missing;
  bool enough = false;
};

/// The result, and the last pair that was taken as a run would get it: rows lie on rows.
struct CapturedCalibration {
  CalibrationResult result;
  cv::Mat left;
  cv::Mat right;
};

/// Not to be used from two threads at once.
class BoardCapture {
 public:
  /// `keep`: a folder for what is taken, left/001.png and right/001.png and so on, as
  /// findBoards() reads them; empty: kept nowhere.
  BoardCapture(Board board, std::filesystem::path keep) : board_(board), keep_(std::move(keep)) {}

  /// Throws BadInput for a pair of images of another size than the first, RunFailed where what is
  /// taken cannot be written.
  CaptureStatus look(double time_s, const cv::Mat& left, const cv::Mat& right);

  /// Of all that was taken. Throws as calibrateStereo().
  CapturedCalibration calibrate(const std::string& source) const;

 private:
  BoardVerdict lookClosely(const cv::Mat& left, const cv::Mat& right, CaptureStatus& status);
  void keep(const std::string& name, const cv::Mat& left, const cv::Mat& right) const;

  Board board_;
  std::filesystem::path keep_;
  std::optional<BoardSurvey> survey_;
  BoardImages images_;
  cv::Mat last_left_;  ///< of those taken
  cv::Mat last_right_;
  long looks_ = 0;
};

}  // namespace handmap
