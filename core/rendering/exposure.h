// From radiance to grey levels: exposure, gamma, sensor noise.
#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

namespace handmap {

/// What brings a picture (linear RGB) to a middle brightness; in part only, as cameras do.
float automaticExposure(const cv::Mat3f& radiance);

/// 8 bit BGR, or grey. Values above the range saturate. Noise of `sigma` grey levels follows from
/// the numbers.
cv::Mat developed(const cv::Mat3f& radiance, float exposure, bool colour, double sigma,
                  std::uint64_t seed, std::uint32_t frame, std::uint32_t picture);

}  // namespace handmap
