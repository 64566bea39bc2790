#include "app/cli/image_truth_writer.h"

#include <cmath>

#include "core/recording/image_file.h"
#include "core/recording/recording.h"

namespace handmap {

namespace {

cv::Mat1w inCentimetres(const cv::Mat1f& depth_m) {
  cv::Mat1w centimetres(depth_m.size());
  for (int row = 0; row < depth_m.rows; ++row) {
    for (int column = 0; column < depth_m.cols; ++column) {
      const float value = std::round(100.0F * depth_m(row, column));
      centimetres(row, column) = value <= 65535.0F ? static_cast<std::uint16_t>(value) : 0;
    }
  }
  return centimetres;
}

}  // namespace

void writeImageTruth(const std::filesystem::path& folder, const Observation& observation,
                     const std::vector<ImageTruth>& truths) {
  std::error_code ignored;  // writing into them tells
  std::filesystem::create_directories(folder / "labels", ignored);
  std::filesystem::create_directories(folder / "depth", ignored);
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const std::string name = RecordingWriter::fileName(observation, i, ".png");
    writePng(truths[i].labels, folder / "labels" / name);
    writePng(inCentimetres(truths[i].depth), folder / "depth" / name);
  }
}

}  // namespace handmap
