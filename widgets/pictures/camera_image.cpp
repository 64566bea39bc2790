#include "widgets/pictures/camera_image.h"

namespace handmap {

QImage sharedImage(const cv::Mat& image) {
  if (image.empty() || image.depth() != CV_8U) return {};
  if (image.channels() != 1 && image.channels() != 3) return {};
  const auto format = image.channels() == 1 ? QImage::Format_Grayscale8 : QImage::Format_BGR888;
  return {image.data, image.cols, image.rows, static_cast<qsizetype>(image.step), format};
}

QImage cameraImage(const cv::Mat& image) { return sharedImage(image).copy(); }

}  // namespace handmap
