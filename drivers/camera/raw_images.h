// Images as the sensors of industrial cameras give them: pure functions.
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace handmap {

/// Which colours the four pixels at the upper left see, row by row. None: all see grey.
enum class BayerTile { None, Rggb, Gbrg, Grbg, Bggr };

/// Point Grey's register BAYER_TILE_MAPPING: four letters, "RGGB", "YYYY" and so on. What is not
/// known is taken for grey.
BayerTile bayerTileOf(std::uint32_t letters);

/// The images of a stereo head that come byte by byte in turn: `count` of them, each of that size.
/// `bytes` has count · width · height of them.
std::vector<cv::Mat1b> deinterlaced(const std::uint8_t* bytes, cv::Size size, int count);

/// What the sensor saw: three channels (BGR), or the image itself where it is grey.
cv::Mat developed(const cv::Mat1b& raw, BayerTile tile);

}  // namespace handmap
