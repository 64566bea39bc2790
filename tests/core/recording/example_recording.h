// A small recording on disk: six rows of a moving robot, images in all, points in every other one.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "core/recording/image_file.h"
#include "core/recording/recording.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap::test {

inline std::string pointBytes(const std::vector<RangePoint>& points) {
  std::string bytes(points.size() * sizeof(RangePoint), '\0');
  std::memcpy(bytes.data(), points.data(), bytes.size());
  return bytes;
}

inline cv::Mat exampleImage(int seed, int width = 32, int height = 16, int type = CV_8UC1) {
  cv::Mat image(height, width, type);
  cv::RNG random(static_cast<std::uint64_t>(seed) + 1);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

inline bool sameImage(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_L1) == 0.0;
}

class ExampleRecording {
 public:
  static constexpr int kRows = 6;

  ExampleRecording() {
    folder_.write("recording.json", R"({"format": "handmap-recording", "version": 1,
      "name": "Example", "range_limit_m": 30, "licence": "none",
      "camera": {"calibration": "calib.txt", "left": "P0", "right": "P1", "rectified": true,
                 "mount": {"x_m": 0.1, "y_m": 0.2, "z_m": 1.5, "pitch_deg": 3, "yaw_deg": 4}}})");
    folder_.write("calib.txt",
                  "calib_time: 09-Jan-2012\n"
                  "P0: 700 0 16 0 0 710 8 0 0 0 1 0\n"
                  "P1: 700 0 16 -350 0 710 8 0 0 0 1 0\n");
    std::string table = "frame,time_s,stop,pan_deg,left,right,points\n";
    std::string odometry = "# time x y z qx qy qz qw\n";
    for (int i = 0; i < kRows; ++i) {
      const std::string n = std::to_string(i);
      table += n + ",1" + n + ",,,image_0/" + n + ".png,image_1/" + n + ".png,";
      if (i % 2 == 0) table += "points/" + n + ".bin";
      table += "\n";
      odometry += "1" + n + " " + n + " 0 0 0 0 0 1\n";
      writeImages(i);
      if (i % 2 == 0) {
        folder_.write("points/" + n + ".bin",
                      pointBytes({{static_cast<float>(i), 2, 3, 1}, {4, 5, 6, 0.5f}}));
      }
    }
    folder_.write("frames.csv", table);
    folder_.write("odometry.tum", odometry);
    folder_.write("truth.tum", "10 5 6 0 0 0 0 1\n15 10 6 0 0 0 0 1\n");
  }

  const std::filesystem::path& path() const { return folder_.path(); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  void writeImages(int i) const {
    for (int side = 0; side < 2; ++side) {
      const auto directory = folder_.path() / ("image_" + std::to_string(side));
      std::filesystem::create_directories(directory);
      writePng(exampleImage(10 * i + side), directory / (std::to_string(i) + ".png"));
    }
  }

  TemporaryFolder folder_;
};

/// The frames that a source gives; unreadable ones are negative.
inline std::vector<int> framesOf(ObservationSource& source) {
  std::vector<int> frames;
  for (;;) {
    try {
      const auto observation = source.next();
      if (!observation) return frames;
      frames.push_back(observation->frame);
    } catch (const FrameError& error) {
      frames.push_back(-error.frame());
    }
  }
}

}  // namespace handmap::test
