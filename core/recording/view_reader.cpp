#include "core/recording/view_reader.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/recording/image_file.h"

namespace handmap {

void ViewReader::readImages(const FrameRow& row, View& view) {
  view.left = readSized(row.left);
  view.right = readSized(row.right);
}

void ViewReader::readPoints(const FrameRow& row, View& view) const {
  view.points = handmap::readPoints(folder_ / row.points);
}

cv::Mat ViewReader::readSized(const std::string& name) {
  cv::Mat image = readImage(folder_ / name);
  if (size_.empty()) size_ = image.size();
  if (image.size() != size_) {
    throwBadInput((folder_ / name).string(), "",
                  fmt::format("{} × {} pixels", image.cols, image.rows),
                  fmt::format("{} × {} as the images before", size_.width, size_.height));
  }
  return image;
}

}  // namespace handmap
