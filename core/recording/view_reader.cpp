#include "core/recording/view_reader.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace {

/// A robot that turns by 30°/s has turned by 0.3° in that time: some pixels of disparity.
constexpr double kMaxDelay_s = 0.010;
constexpr double kMaxOffCentre = 0.3;  // of the width

void checkDelay(const FrameRow& row, const std::string& file) {
  if (!row.right_time_s || std::abs(*row.right_time_s - row.time_s) <= kMaxDelay_s) return;
  throwBadInput(file, "",
                phrase("the right image taken at {} s, the left one at {} s",
                       formatNumber(*row.right_time_s), formatNumber(row.time_s)),
                phrase("both within {:g} s", kMaxDelay_s));
}

/// Images that were scaled after the calibration.
void checkCentre(const StereoCamera& camera, cv::Size size, const std::string& file) {
  const double middle = 0.5 * (size.width - 1);
  if (std::abs(camera.cx - middle) <= kMaxOffCentre * size.width) return;
  throwBadInput(
      file, "", phrase("{} × {} pixels", size.width, size.height),
      phrase("images that the calibration belongs to: its principal point is at x = {:g} px",
             camera.cx));
}

}  // namespace

ViewReader::ViewReader(const Recording& recording)
    : folder_(recording.folder),
      camera_(recording.camera),
      rectifier_(recording.rectifier),
      points_as_(recording.points_as) {
  if (rectifier_) size_ = rectifier_->size();
}

void ViewReader::readImages(const FrameRow& row, View& view) {
  const std::string right = (folder_ / row.right).string();
  checkDelay(row, right);
  view.left = readSized(row.left);
  view.right = readSized(row.right);
  checkPicture(view.left, (folder_ / row.left).string());
  checkPicture(view.right, right);
  if (rectifier_) {
    view.left = rectifier_->left(view.left);
    view.right = rectifier_->right(view.right);
  }
  swap_check_(view.left, view.right, right);
}

void ViewReader::readPoints(const FrameRow& row, View& view) const {
  handmap::readPoints(folder_ / row.points, view);
  if (points_as_ == PointsReading{}) return;
  for (RangePoint& point : *view.points) point = points_as_(point);
}

cv::Mat ViewReader::readSized(const std::string& name) {
  const std::string file = (folder_ / name).string();
  cv::Mat image = readImage(folder_ / name);
  if (size_.empty()) {
    if (camera_) checkCentre(*camera_, image.size(), file);
    size_ = image.size();
  }
  if (image.size() != size_) {
    throwBadInput(file, "", phrase("{} × {} pixels", image.cols, image.rows),
                  phrase("{} × {} as {}", size_.width, size_.height,
                         rectifier_ ? phrase("the calibration says")
                                    : phrase("the images before: one camera")));
  }
  return image;
}

}  // namespace handmap
