#include "drivers/camera/frame_check.h"

#include <cstring>

#include "core/base/phrase.h"

namespace handmap {

namespace {

/// What was not transmitted is filled with one grey or with black. Of a picture of the world not so
/// much of the height is one colour to the bit.
constexpr double kMissingShare = 0.2;

std::size_t rowBytes(const cv::Mat& image) {
  return static_cast<std::size_t>(image.cols) * image.elemSize();
}

bool isOneColour(const cv::Mat& image, int row, const unsigned char* colour) {
  const unsigned char* bytes = image.ptr(row);
  const std::size_t pixel = image.elemSize();
  for (std::size_t i = 0; i < rowBytes(image); i += pixel) {
    if (std::memcmp(bytes + i, colour, pixel) != 0) return false;
  }
  return true;
}

bool isHalf(const cv::Mat& image) {
  const unsigned char* colour = image.ptr(image.rows - 1);
  int row = image.rows - 1;
  while (row >= 0 && isOneColour(image, row, colour)) --row;
  const int missing = image.rows - 1 - row;
  return row >= 0 && missing >= kMissingShare * image.rows;
}

bool isSame(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  for (int row = 0; row < a.rows; ++row) {
    if (std::memcmp(a.ptr(row), b.ptr(row), rowBytes(a)) != 0) return false;
  }
  return true;
}

}  // namespace

std::string nameOf(FrameFault fault) {
  switch (fault) {
    case FrameFault::None:
      return "";
    case FrameFault::WrongSize:
      return phrase("image of another size");
    case FrameFault::Half:
      return phrase("half image");
    case FrameFault::Repeated:
      return phrase("repeated image");
  }
  return "";
}

FrameFault FrameCheck::operator()(const cv::Mat& image) {
  if (expected_.empty()) expected_ = image.size();
  if (image.empty() || image.size() != expected_) return FrameFault::WrongSize;
  if (isSame(image, before_)) {
    ++repeated_;
    return FrameFault::Repeated;
  }
  repeated_ = 0;
  before_ = image;
  return isHalf(image) ? FrameFault::Half : FrameFault::None;
}

}  // namespace handmap
