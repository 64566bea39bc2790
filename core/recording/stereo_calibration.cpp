#include "core/recording/stereo_calibration.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/geometry/pose2.h"
#include "core/recording/image_file.h"
#include "core/recording/opencv_file.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMaxCalibrationBytes = 1u << 16;
constexpr int kMaxSide = 32768;
constexpr double kMinFocal = 0.1;  // of the image's width: wider than a pinhole can be
constexpr double kMaxFocal = 50.0;
constexpr double kMinBaseline_m = 0.005;
constexpr double kMaxBaseline_m = 100.0;
constexpr double kRotationTolerance = 1e-3;
constexpr double kMaxTurn = 0.7;  // rad between the cameras: more leaves nothing in common

using Keys = std::initializer_list<const char*>;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path)
      : file_(path.string()), values_(readFile(path, kMaxCalibrationBytes), file_) {}

  cv::Size size() const {
    const Words* const both = values_.find({"image_size", "size"});
    const cv::Size size =
        both != nullptr && both->size() == 2
            ? cv::Size{side((*both)[0], "image_size"), side((*both)[1], "image_size")}
            : cv::Size{side({"image_width", "width"}), side({"image_height", "height"})};
    if (std::int64_t{size.width} * size.height > kMaxImagePixels) {
      throwBadInput(file_, phrase("{} and {}", "image_width", "image_height"),
                    phrase("{} × {} pixels", size.width, size.height),
                    phrase("at most {} megapixels", kMaxImagePixels / 1'000'000));
    }
    return size;
  }

  cv::Matx33d matrix(Keys keys) const {
    const auto values = numbers(keys, {9});
    return cv::Matx33d(values.data());
  }

  /// The values of a matrix of any shape with one of these counts.
  std::vector<double> numbers(Keys keys, const std::vector<std::size_t>& counts) const {
    const std::string key = *keys.begin();
    const Words* const words = values_.find(keys);
    if (words == nullptr) throwBadInput(file_, key, phrase("nothing"), phrase("a matrix"));
    if (std::find(counts.begin(), counts.end(), words->size()) == counts.end()) {
      throwBadInput(file_, key, phrase("{} numbers", words->size()),
                    fmt::format("{}", fmt::join(counts, phrase(" or "))));
    }
    std::vector<double> values;
    for (const std::string& word : *words) {
      const auto value = parseFinite(word);
      if (!value) {
        throwBadInput(file_, key, phrase("a value that is no number"), phrase("finite numbers"));
      }
      values.push_back(*value);
    }
    return values;
  }

 private:
  using Words = std::vector<std::string>;

  int side(Keys keys) const {
    const Words* const words = values_.find(keys);
    return side(words != nullptr && words->size() == 1 ? words->front() : "nothing", *keys.begin());
  }

  int side(const std::string& word, const char* key) const {
    const double value = parseFinite(word).value_or(0.0);
    if (!(value >= 1.0 && value <= kMaxSide && value == std::floor(value))) {
      throwBadInput(file_, key, word.substr(0, 40),
                    phrase("the size of the images, 1 to {} pixels", kMaxSide));
    }
    return static_cast<int>(value);
  }

  std::string file_;
  OpenCvFile values_;
};

void checkLens(const LensCalibration& lens, cv::Size size, const std::string& file,
               const std::string& key) {
  const cv::Matx33d& m = lens.matrix;
  for (const double focal : {m(0, 0), m(1, 1)}) {
    if (focal >= kMinFocal * size.width && focal <= kMaxFocal * size.width) continue;
    throwBadInput(file, key, phrase("a focal length of {:g} px", focal),
                  phrase("one from {:g} to {:g} px for images {} px wide", kMinFocal * size.width,
                         kMaxFocal * size.width, size.width));
  }
  const bool centred =
      m(0, 2) > 0.0 && m(0, 2) < size.width && m(1, 2) > 0.0 && m(1, 2) < size.height;
  if (!centred) {
    throwBadInput(file, key, phrase("a principal point at {:g}, {:g}", m(0, 2), m(1, 2)),
                  phrase("one inside the images of {} × {} pixels", size.width, size.height));
  }
  const bool pinhole =
      m(1, 0) == 0.0 && m(2, 0) == 0.0 && m(2, 1) == 0.0 && std::abs(m(2, 2) - 1.0) < 1e-9;
  if (!pinhole) throwBadInput(file, key, phrase("no camera matrix"), "fx 0 cx  0 fy cy  0 0 1");
}

void checkPose(const StereoCalibration& calibration, const std::string& file) {
  const cv::Matx33d& r = calibration.rotation;
  if (cv::norm(r * r.t() - cv::Matx33d::eye()) > kRotationTolerance || cv::determinant(r) < 0.0) {
    throwBadInput(file, "R", phrase("no rotation matrix"), phrase("an orthonormal one"));
  }
  const double turn = std::acos(std::clamp((cv::trace(r) - 1.0) / 2.0, -1.0, 1.0));
  if (turn > kMaxTurn) {
    throwBadInput(file, "R", phrase("cameras turned by {:.0f}°", toDegrees(turn)),
                  phrase("at most {:.0f}°: both look the same way", toDegrees(kMaxTurn)));
  }
  const cv::Vec3d& t = calibration.translation;
  const double length = cv::norm(t);
  if (!(length >= kMinBaseline_m && length <= kMaxBaseline_m)) {
    throwBadInput(file, "T", phrase("cameras {:.4g} apart", length),
                  phrase("{:g} to {:g} metres (T in metres: was the square of the board "
                         "given in metres?)",
                         kMinBaseline_m, kMaxBaseline_m));
  }
  if (std::abs(t[0]) < std::hypot(t[1], t[2])) {
    throwBadInput(file, "T", fmt::format("{:.3g} {:.3g} {:.3g}", t[0], t[1], t[2]),
                  phrase("cameras side by side"));
  }
  if (t[0] > 0.0) {
    throwBadInput(file, "T", phrase("the right camera {:.4g} m left of the left one", t[0]),
                  phrase("it on the right: left and right look swapped"));
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
