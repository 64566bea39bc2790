#include "core/rendering/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/random.h"

namespace handmap {

namespace {

constexpr std::uint32_t kSensor = 25;
constexpr float kMiddle = 0.33F;      // linear mean that a picture is brought to
constexpr float kAdaptation = 0.75F;  // how far
constexpr float kGamma = 2.2F;
constexpr int kSteps = 4096;                         // of the gamma curve
constexpr float kGrey[] = {0.299F, 0.587F, 0.114F};  // ITU-R BT.601

const std::array<float, kSteps + 1>& gammaCurve() {
  static const auto kCurve = [] {
    std::array<float, kSteps + 1> values{};
    for (int i = 0; i <= kSteps; ++i) {
      values[static_cast<std::size_t>(i)] = static_cast<float>(
          255.0 * std::pow(static_cast<double>(i) / kSteps, 1.0 / static_cast<double>(kGamma)));
    }
    return values;
  }();
  return kCurve;
}

/// Goes on above 255: noise must not bring back what is far beyond the range.
float greyLevel(float radiance) {
  if (radiance > 1.0F) return 255.0F + 255.0F / kGamma * (radiance - 1.0F);
  const float place = std::max(radiance, 0.0F) * kSteps;
  const int low = std::min(static_cast<int>(place), kSteps - 1);
  const float* curve = gammaCurve().data() + low;
  return curve[0] + (place - static_cast<float>(low)) * (curve[1] - curve[0]);
}

/// Nearly normal with σ = 1 from 32 random bits: the sum of four bytes.
float nearlyNormal(std::uint32_t bits) {
  constexpr float kSigma = 147.8F;  // of the sum, √(4 (256² - 1) / 12)
  const auto sum = (bits & 255U) + (bits >> 8 & 255U) + (bits >> 16 & 255U) + (bits >> 24);
  return (static_cast<float>(sum) - 510.0F) / kSigma;
}

}  // namespace

float automaticExposure(const cv::Mat3f& radiance) {
  const cv::Mat1f levels = radiance.reshape(1);
  // What saturates does not make a camera close further.
  double sum = 0.0;
  for (int row = 0; row < levels.rows; ++row) {
    const float* line = levels[row];
    float of_row = 0.0F;
    for (int i = 0; i < levels.cols; ++i) of_row += std::min(line[i], 1.2F);
    sum += static_cast<double>(of_row);
  }
  const auto mean = static_cast<float>(sum / static_cast<double>(levels.total()));
  return std::pow(kMiddle / std::max(mean, 1e-3F), kAdaptation);
}

cv::Mat developed(const cv::Mat3f& radiance, float exposure, bool colour, double sigma,
                  std::uint64_t seed, std::uint32_t frame, std::uint32_t picture) {
  cv::Mat image(radiance.size(), colour ? CV_8UC3 : CV_8UC1);
  const auto noise = static_cast<float>(sigma);
  parallelStretches(image.rows, 16, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      const std::uint32_t line = picture << 16 | static_cast<std::uint32_t>(row);
      RandomStream random(seed, frame, line, kSensor);
      const cv::Vec3f* in = radiance[row];
      std::uint8_t* out = image.ptr(row);
      const auto put = [&](float level) {
        const float noisy = level + noise * nearlyNormal(random());
        *out++ = static_cast<std::uint8_t>(std::clamp(noisy + 0.5F, 0.0F, 255.0F));
      };
      for (int column = 0; column < image.cols; ++column) {
        const cv::Vec3f c = in[column] * exposure;
        if (!colour) {
          put(greyLevel(kGrey[0] * c[0] + kGrey[1] * c[1] + kGrey[2] * c[2]));
          continue;
        }
        for (const int channel : {2, 1, 0}) put(greyLevel(c[channel]));
      }
    }
  });
  return image;
}

}  // namespace handmap
