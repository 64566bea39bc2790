#include "core/calibration/board_capture.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/recording/image_file.h"
#include "core/recording/rectifier.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

/// Pixels from dark to bright; OpenCV's own advice for estimateChessboardSharpness().
constexpr double kSharp_px = 3.0;

void requireSize(const cv::Mat& image, cv::Size expected) {
  if (image.size() == expected) return;
  throwBadInput(phrase("cameras"), "", phrase("an image of {} × {} pixels", image.cols, image.rows),
                phrase("{} × {} as the images before", expected.width, expected.height));
}

}  // namespace

CaptureStatus BoardCapture::look(double time_s, const cv::Mat& left, const cv::Mat& right) {
  if (!survey_) {
    images_.size = left.size();
    survey_.emplace(board_, images_.size);
  }
  requireSize(left, images_.size);
  requireSize(right, images_.size);
  CaptureStatus status;
  status.looks = ++looks_;
  status.left = left;
  status.right = right;
  status.left_corners = glimpseCorners(left, board_);
  status.right_corners = glimpseCorners(right, board_);
  const auto verdict = survey_->judge(time_s, status.left_corners, status.right_corners);
  status.verdict = verdict ? *verdict : lookClosely(left, right, status);
  status.taken = survey_->taken();
  status.missing = survey_->missing();
  status.enough = survey_->isEnough();
  return status;
}

BoardVerdict BoardCapture::lookClosely(const cv::Mat& left, const cv::Mat& right,
                                       CaptureStatus& status) {
  BoardView view;
  view.name = fmt::format("{:03}", images_.views.size() + 1);
  view.left = findCorners(left, board_);
  view.right = findCorners(right, board_);
  if (view.left.empty() && view.right.empty()) return BoardVerdict::NotSeen;
  if (view.left.empty() || view.right.empty()) return BoardVerdict::InOneImage;
  alignOrder(view);
  const bool sharp = blurOf(left, board_, view.left) <= kSharp_px &&
                     blurOf(right, board_, view.right) <= kSharp_px;
  if (!sharp) return BoardVerdict::Blurred;
  if (!keep_.empty()) keep(view.name, left, right);
  status.left_corners = view.left;
  status.right_corners = view.right;
  survey_->take(view);
  images_.views.push_back(std::move(view));
  last_left_ = left.clone();
  last_right_ = right.clone();
  return BoardVerdict::Taken;
}

void BoardCapture::keep(const std::string& name, const cv::Mat& left, const cv::Mat& right) const {
  for (const auto& [side, image] : {std::pair("left", left), std::pair("right", right)}) {
    std::error_code error;
    fs::create_directories(keep_ / side, error);
    writePng(image, keep_ / side / (name + ".png"));
  }
}

CapturedCalibration BoardCapture::calibrate(const std::string& source) const {
  CapturedCalibration captured;
  captured.result = calibrateStereo(images_, board_, source);
  const Rectifier rectifier(captured.result.calibration, source);
  captured.left = rectifier.left(last_left_);
  captured.right = rectifier.right(last_right_);
  return captured;
}

}  // namespace handmap
