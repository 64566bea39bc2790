#include "core/paper/handwriting.h"

#include <algorithm>

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

namespace handmap {

namespace {

constexpr double kInked = 70.0;  // of a pixel made of several, to be ink: thin strokes stay

std::optional<int> numberOf(const nlohmann::json& value, int most) {
  if (!value.is_number_integer()) return std::nullopt;
  const auto number = value.get<std::int64_t>();
  if (number < 0 || number > most) return std::nullopt;
  return static_cast<int>(number);
}

}  // namespace

std::string writingText(const cv::Mat& ink) {
  const double scale = std::min({1.0, static_cast<double>(kWritingWidth_px) / ink.cols,
                                 static_cast<double>(kWritingHeight_px) / ink.rows});
  const cv::Size size(std::max(1, static_cast<int>(ink.cols * scale)),
                      std::max(1, static_cast<int>(ink.rows * scale)));
  cv::Mat small;
  cv::resize(ink, small, size, 0.0, 0.0, cv::INTER_AREA);
  cv::threshold(small, small, kInked, 255, cv::THRESH_BINARY);
  nlohmann::json runs = {small.cols, small.rows};
  int run = 0;
  std::uint8_t now = 0;
  for (int y = 0; y < small.rows; ++y) {
    for (int x = 0; x < small.cols; ++x) {
      if (small.at<std::uint8_t>(y, x) != now) {
        runs.push_back(run);
        run = 0;
        now = small.at<std::uint8_t>(y, x);
      }
      ++run;
    }
  }
  runs.push_back(run);
  return runs.dump();
}

cv::Mat writingOf(const Building& building) {
  const auto text = building.unknown.find(kWritingKey);
  if (text == building.unknown.end()) return {};
  const nlohmann::json runs = nlohmann::json::parse(text->second, nullptr, false);
  if (!runs.is_array() || runs.size() < 3) return {};
  const auto width = numberOf(runs[0], kWritingWidth_px);
  const auto height = numberOf(runs[1], kWritingHeight_px);
  if (!width || !height || *width == 0 || *height == 0) return {};
  cv::Mat ink = cv::Mat::zeros(*height, *width, CV_8U);
  const auto total = static_cast<int>(ink.total());
  int at = 0;
  for (std::size_t i = 2; i < runs.size(); ++i) {
    const auto run = numberOf(runs[i], total - at);
    if (!run) return {};
    if (i % 2 == 1) std::fill_n(ink.data + at, *run, std::uint8_t{255});
    at += *run;
  }
  return at == total ? ink : cv::Mat();
}

}  // namespace handmap
