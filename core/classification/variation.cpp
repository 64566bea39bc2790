#include "core/classification/variation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <opencv2/imgproc.hpp>

namespace handmap {

namespace {

constexpr double kGain = 1.5;      // exposure, to either side
constexpr double kGamma = 1.4;     // contrast, to either side
constexpr double kBalance = 1.15;  // of each colour, to either side
constexpr double kBlur_px = 1.5;
constexpr double kNoise = 8.0;  // grey levels

double toEitherSide(double factor, RandomStream& random) {
  return std::pow(factor, random.uniform(-1.0, 1.0));
}

void changeLight(cv::Mat& image, RandomStream& random) {
  const double gain = toEitherSide(kGain, random);
  const double gamma = toEitherSide(kGamma, random);
  const int channels = image.channels();
  cv::Mat curve(1, 256, CV_8UC(channels));
  for (int channel = 0; channel < channels; ++channel) {
    const double balance = channels == 1 ? 1.0 : toEitherSide(kBalance, random);
    for (int level = 0; level < 256; ++level) {
      const double value = 255.0 * gain * balance * std::pow(level / 255.0, gamma);
      curve.ptr<std::uint8_t>()[level * channels + channel] =
          cv::saturate_cast<std::uint8_t>(value);
    }
  }
  cv::LUT(image, curve, image);
}

void addNoise(cv::Mat& image, double sigma, RandomStream& random) {
  const int values = image.cols * image.channels();
  for (int row = 0; row < image.rows; ++row) {
    std::uint8_t* line = image.ptr<std::uint8_t>(row);
    for (int i = 0; i < values; ++i) {
      line[i] = cv::saturate_cast<std::uint8_t>(line[i] + random.normal(0.0, sigma));
    }
  }
}

}  // namespace

cv::Mat varied(const cv::Mat& image, RandomStream& random) {
  cv::Mat result;
  const double blur = random.uniform(0.0, kBlur_px);
  cv::GaussianBlur(image, result, {}, std::max(blur, 0.1));
  changeLight(result, random);
  addNoise(result, random.uniform(0.0, kNoise), random);
  return result;
}

}  // namespace handmap
