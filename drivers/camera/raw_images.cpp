#include "drivers/camera/raw_images.h"

#include <opencv2/imgproc.hpp>

namespace handmap {

namespace {

constexpr std::uint32_t letters(const char (&word)[5]) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(word[i]);
  return value;
}

}  // namespace

BayerTile bayerTileOf(std::uint32_t tile) {
  switch (tile) {
    case letters("RGGB"):
      return BayerTile::Rggb;
    case letters("GBRG"):
      return BayerTile::Gbrg;
    case letters("GRBG"):
      return BayerTile::Grbg;
    case letters("BGGR"):
      return BayerTile::Bggr;
    default:
      return BayerTile::None;
  }
}

std::vector<cv::Mat1b> deinterlaced(const std::uint8_t* bytes, cv::Size size, int count) {
  // One channel for each image: what OpenCV splits.
  const cv::Mat together(size, CV_8UC(count), const_cast<std::uint8_t*>(bytes));
  std::vector<cv::Mat> images;
  cv::split(together, images);
  return {images.begin(), images.end()};
}

/// OpenCV's own names of the tiles begin elsewhere; these are the sensor's.
cv::Mat developed(const cv::Mat1b& raw, BayerTile tile) {
  cv::Mat image;
  switch (tile) {
    case BayerTile::None:
      return raw;
    case BayerTile::Rggb:
      cv::cvtColor(raw, image, cv::COLOR_BayerRGGB2BGR);
      break;
    case BayerTile::Gbrg:
      cv::cvtColor(raw, image, cv::COLOR_BayerGBRG2BGR);
      break;
    case BayerTile::Grbg:
      cv::cvtColor(raw, image, cv::COLOR_BayerGRBG2BGR);
      break;
    case BayerTile::Bggr:
      cv::cvtColor(raw, image, cv::COLOR_BayerBGGR2BGR);
      break;
  }
  return image;
}

}  // namespace handmap
