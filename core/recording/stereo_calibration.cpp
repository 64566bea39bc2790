#include "core/recording/stereo_calibration.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>
#include <opencv2/core/persistence.hpp>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/geometry/pose2.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMaxBytes = 1u << 16;
constexpr std::size_t kMaxNodes = 500;  // the parsers of OpenCV recurse
constexpr int kMaxSide = 32768;
constexpr double kMinFocal = 0.1;  // of the image's width: wider than a pinhole can be
constexpr double kMaxFocal = 50.0;
constexpr double kMinBaseline_m = 0.005;
constexpr double kMaxBaseline_m = 100.0;
constexpr double kRotationTolerance = 1e-3;
constexpr double kMaxTurn = 0.7;  // rad between the cameras: more leaves nothing in common

using Keys = std::initializer_list<const char*>;

/// An upper bound of how deep the text nests.
std::size_t nodesOf(std::string_view text) {
  std::size_t nodes = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool item = c == '-' && i + 1 < text.size() && std::isspace(std::uint8_t(text[i + 1]));
    nodes += c == '[' || c == '{' || c == '<' || item ? 1 : 0;
  }
  return nodes;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : file_(path.string()) {
    const std::string content = readFile(path, kMaxBytes);
    const char* const expected = "a YAML or XML file of OpenCV with M1 D1 M2 D2 R T";
    if (trimmed(content).empty()) throwBadInput(file_, "", "an empty file", expected);
    if (nodesOf(content) > kMaxNodes) throwBadInput(file_, "", "too many values", expected);
    try {
      storage_.open(content, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    } catch (const std::exception&) {
      storage_.release();
    }
    if (!storage_.isOpened()) throwBadInput(file_, "", "no calibration of OpenCV", expected);
  }

  cv::Size size() const {
    if (const cv::FileNode both = find({"image_size", "size"}); both.isSeq() && both.size() == 2) {
      return {side(both[0], "image_size"), side(both[1], "image_size")};
    }
    return {side(find({"image_width", "width"}), "image_width"),
            side(find({"image_height", "height"}), "image_height")};
  }

  cv::Matx33d matrix(Keys keys) const {
    const auto values = numbers(keys, {9});
    return cv::Matx33d(values.data());
  }

  /// The values of a matrix of any shape with one of these counts. Not by the reader of OpenCV,
  /// which allocates whatever the file asks for.
  std::vector<double> numbers(Keys keys, const std::vector<std::size_t>& counts) const {
    const std::string key = *keys.begin();
    const cv::FileNode node = find(keys);
    if (node.empty()) throwBadInput(file_, key, "nothing", "a matrix");
    const cv::FileNode data = node.isMap() ? node["data"] : node;
    const std::size_t count = data.isSeq() ? data.size() : 0;
    if (std::find(counts.begin(), counts.end(), count) == counts.end()) {
      throwBadInput(file_, key, fmt::format("{} numbers", count),
                    fmt::format("{}", fmt::join(counts, " or ")));
    }
    std::vector<double> values;
    for (const cv::FileNode value : data) {
      const bool good = (value.isInt() || value.isReal()) && std::isfinite(value.real());
      if (!good) throwBadInput(file_, key, "a value that is no number", "finite numbers");
      values.push_back(value.real());
    }
    return values;
  }

 private:
  cv::FileNode find(Keys keys) const {
    for (const char* key : keys) {
      if (const cv::FileNode node = storage_[key]; !node.empty()) return node;
    }
    return {};
  }

  int side(const cv::FileNode& node, const char* key) const {
    const double value = node.isInt() || node.isReal() ? node.real() : 0.0;
    if (!(value >= 1.0 && value <= kMaxSide && value == std::floor(value))) {
      throwBadInput(file_, key, node.empty() ? "nothing" : formatNumber(value),
                    fmt::format("the size of the images, 1 to {} pixels", kMaxSide));
    }
    return static_cast<int>(value);
  }

  std::string file_;
  cv::FileStorage storage_;
};

void checkLens(const LensCalibration& lens, cv::Size size, const std::string& file,
               const std::string& key) {
  const cv::Matx33d& m = lens.matrix;
  for (const double focal : {m(0, 0), m(1, 1)}) {
    if (focal >= kMinFocal * size.width && focal <= kMaxFocal * size.width) continue;
    throwBadInput(file, key, fmt::format("a focal length of {:g} px", focal),
                  fmt::format("one from {:g} to {:g} px for images {} px wide",
                              kMinFocal * size.width, kMaxFocal * size.width, size.width));
  }
  const bool centred =
      m(0, 2) > 0.0 && m(0, 2) < size.width && m(1, 2) > 0.0 && m(1, 2) < size.height;
  if (!centred) {
    throwBadInput(file, key, fmt::format("a principal point at {:g}, {:g}", m(0, 2), m(1, 2)),
                  fmt::format("one inside the images of {} × {} pixels", size.width, size.height));
  }
  const bool pinhole =
      m(1, 0) == 0.0 && m(2, 0) == 0.0 && m(2, 1) == 0.0 && std::abs(m(2, 2) - 1.0) < 1e-9;
  if (!pinhole) throwBadInput(file, key, "no camera matrix", "fx 0 cx  0 fy cy  0 0 1");
}

void checkPose(const StereoCalibration& calibration, const std::string& file) {
  const cv::Matx33d& r = calibration.rotation;
  if (cv::norm(r * r.t() - cv::Matx33d::eye()) > kRotationTolerance || cv::determinant(r) < 0.0) {
    throwBadInput(file, "R", "no rotation matrix", "an orthonormal one");
  }
  const double turn = std::acos(std::clamp((cv::trace(r) - 1.0) / 2.0, -1.0, 1.0));
  if (turn > kMaxTurn) {
    throwBadInput(file, "R", fmt::format("cameras turned by {:.0f}°", toDegrees(turn)),
                  fmt::format("at most {:.0f}°: both look the same way", toDegrees(kMaxTurn)));
  }
  const cv::Vec3d& t = calibration.translation;
  const double length = cv::norm(t);
  if (!(length >= kMinBaseline_m && length <= kMaxBaseline_m)) {
    throwBadInput(file, "T", fmt::format("cameras {:.4g} apart", length),
                  fmt::format("{:g} to {:g} metres (T in metres: was the square of the board "
                              "given in metres?)",
                              kMinBaseline_m, kMaxBaseline_m));
  }
  if (std::abs(t[0]) < std::hypot(t[1], t[2])) {
    throwBadInput(file, "T", fmt::format("{:.3g} {:.3g} {:.3g}", t[0], t[1], t[2]),
                  "cameras side by side");
  }
  if (t[0] > 0.0) {
    throwBadInput(file, "T", fmt::format("the right camera {:.4g} m left of the left one", t[0]),
                  "it on the right: left and right look swapped");
  }
}

std::string formatMatrix(const char* key, int rows, int columns, const double* values) {
  std::string text;
  for (int i = 0; i < rows * columns; ++i) {
    const std::string number = fmt::format("{:.17e}", values[i]);  // a real even where whole
    text += (i == 0 ? "" : ", ") + number;
  }
  return fmt::format("{}: !!opencv-matrix\n   rows: {}\n   cols: {}\n   dt: d\n   data: [ {} ]\n",
                     key, rows, columns, text);
}

}  // namespace

void checkStereoCalibration(const StereoCalibration& calibration, const std::string& file) {
  checkLens(calibration.left, calibration.size, file, "M1");
  checkLens(calibration.right, calibration.size, file, "M2");
  checkPose(calibration, file);
}

StereoCalibration readStereoCalibration(const std::filesystem::path& path) {
  const Reader reader(path);
  const std::vector<std::size_t> lens{4, 5, 8, 12, 14};
  StereoCalibration calibration;
  calibration.size = reader.size();
  calibration.left.matrix = reader.matrix({"M1", "camera_matrix_left", "K1"});
  calibration.left.distortion = reader.numbers({"D1", "distortion_left"}, lens);
  calibration.right.matrix = reader.matrix({"M2", "camera_matrix_right", "K2"});
  calibration.right.distortion = reader.numbers({"D2", "distortion_right"}, lens);
  calibration.rotation = reader.matrix({"R"});
  calibration.translation = cv::Vec3d(reader.numbers({"T"}, {3}).data());
  checkStereoCalibration(calibration, path.string());
  return calibration;
}

std::string formatStereoCalibration(const StereoCalibration& calibration) {
  const auto lens = [](const char* matrix, const char* distortion, const LensCalibration& of) {
    return formatMatrix(matrix, 3, 3, of.matrix.val) +
           formatMatrix(distortion, 1, static_cast<int>(of.distortion.size()),
                        of.distortion.data());
  };
  return fmt::format("%YAML:1.0\n---\nimage_width: {}\nimage_height: {}\n", calibration.size.width,
                     calibration.size.height) +
         lens("M1", "D1", calibration.left) + lens("M2", "D2", calibration.right) +
         formatMatrix("R", 3, 3, calibration.rotation.val) +
         formatMatrix("T", 3, 1, calibration.translation.val);
}

}  // namespace handmap
