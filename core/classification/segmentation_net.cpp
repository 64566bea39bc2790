#include "core/classification/segmentation_net.h"

#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/classification/windows.h"

namespace handmap {

namespace {

constexpr int kStride_px = 32;  // networks halve an image up to five times
constexpr int kMostClasses = 1000;
constexpr int kMostSide_px = 8192;

std::array<double, 3> readThree(const JsonValue& json, double low, double high) {
  const std::vector<JsonValue> items = json.items(3);
  if (items.size() != 3) json.fail(phrase("3 numbers: red, green, blue"));
  return {items[0].number(low, high), items[1].number(low, high), items[2].number(low, high)};
}

/// False where nothing says which class a building is.
bool readInput(const std::filesystem::path& path, SegmentationInput& input) {
  if (!std::filesystem::exists(path)) return false;
  const nlohmann::json parsed = parseJson(readFile(path, 1U << 16U), path.string());
  const JsonValue json = JsonValue(parsed, path.string()).object();
  const auto integer = [&](const char* key, int low, int high) -> std::optional<int> {
    const auto value = json.find(key);
    if (!value) return std::nullopt;
    return static_cast<int>(value->integer(low, high));
  };
  const auto width = integer("width", 1, kMostSide_px);
  const auto height = integer("height", 1, kMostSide_px);
  if (width.has_value() != height.has_value()) {
    json.fail(phrase("\"width\" and \"height\", or neither"));
  }
  if (width) input.size = cv::Size(*width, *height);
  if (const auto mean = json.find("mean")) input.mean = readThree(*mean, -10.0, 10.0);
  if (const auto deviation = json.find("deviation")) {
    input.deviation = readThree(*deviation, 1e-3, 1e3);
  }
  const auto building = integer("building_class", 0, kMostClasses);
  if (building) input.building_class = *building;
  return building.has_value();
}

cv::Size wholeStrides(cv::Size image) {
  const auto up = [](int side) { return (side + kStride_px - 1) / kStride_px * kStride_px; };
  return {up(image.width), up(image.height)};
}

/// Whether the numbers of the classes are probabilities already; of one class: between 0 and 1.
bool sumToOne(const float* scores, int classes, std::size_t pixels) {
  constexpr float kRounding = 1e-3F;
  for (std::size_t i = 0; i < pixels; ++i) {
    float sum = 0.0F;
    for (std::size_t c = 0; c < static_cast<std::size_t>(classes); ++c) {
      const float score = scores[c * pixels + i];
      if (!(score >= 0.0F && score <= 1.0F)) return false;
      sum += score;
    }
    if (classes > 1 && std::abs(sum - 1.0F) > kRounding) return false;
  }
  return true;
}

/// What OpenCV says, without where in its source.
std::string reasonOf(const cv::Exception& error) {
  return error.err.empty() ? error.msg : error.err;
}

}  // namespace

std::shared_ptr<const SegmentationNet> SegmentationNet::load(const std::filesystem::path& path,
                                                             std::optional<int> building_class) {
  if (!std::filesystem::is_regular_file(path)) {
    throwBadInput(path.string(), "", phrase("no file"), phrase("a network in ONNX form"));
  }
  SegmentationInput input;
  const std::filesystem::path beside = std::filesystem::path(path).replace_extension(".json");
  const bool said = readInput(beside, input);
  if (building_class) input.building_class = *building_class;
  if (!said && !building_class) {
    throw Error(ErrorCode::BadInput,
                phrase("{}: found no number of its class for buildings", path.string()),
                phrase("give it: --building-class N, or {{\"building_class\": N}} in {}",
                       beside.filename().string()));
  }
  cv::dnn::Net net;
  try {
    net = cv::dnn::readNetFromONNX(path.string());
  } catch (const cv::Exception& error) {
    throwBadInput(path.string(), "", reasonOf(error), phrase("a network in ONNX form"));
  }
  if (net.empty()) {
    throwBadInput(path.string(), "", phrase("nothing"), phrase("a network in ONNX form"));
  }
  auto made = std::make_shared<const SegmentationNet>(path.string(), net, input);
  const cv::Size size = input.size.value_or(cv::Size(kStride_px, kStride_px));
  made->probabilities(cv::Mat3b(size, cv::Vec3b()));  // says now what would be said in a run
  return made;
}

SegmentationNet::SegmentationNet(std::string name, const cv::dnn::Net& net,
                                 const SegmentationInput& input)
    : name_(std::move(name)), input_(input), net_(net) {
  net_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
  net_.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
}

/// Scores: classes × rows × columns, or rows × columns of one class.
cv::Mat SegmentationNet::forward(const cv::Mat& image) const {
  cv::Mat colour = image;
  if (image.channels() == 1) cv::cvtColor(image, colour, cv::COLOR_GRAY2BGR);
  cv::Mat values;
  colour.convertTo(values, CV_32F, 1.0 / 255.0);
  const auto blue_first = [](const std::array<double, 3>& rgb) {
    return cv::Scalar(rgb[2], rgb[1], rgb[0], 1.0);
  };
  cv::subtract(values, blue_first(input_.mean), values);
  cv::divide(values, blue_first(input_.deviation), values);
  const cv::Size size = input_.size.value_or(wholeStrides(image.size()));
  const cv::Mat blob = cv::dnn::blobFromImage(values, 1.0, size, {}, true, false, CV_32F);
  const std::scoped_lock lock(mutex_);
  try {
    net_.setInput(blob);
    return net_.forward().clone();
  } catch (const cv::Exception& error) {
    throw Error(
        ErrorCode::BadInput,
        phrase("{}: cannot take an image of {}×{}: {}", name_, size.width, size.height,
               reasonOf(error)),
        phrase("a network that insists on a size needs \"width\" and \"height\" in its .json"));
  }
}

cv::Mat1f SegmentationNet::buildingShare(const cv::Mat& output) const {
  const auto fail = [&] {
    std::string shape;
    for (int i = 0; i < output.dims; ++i)
      shape += fmt::format("{}{}", i ? "×" : "", output.size[i]);
    throwBadInput(name_, "output", shape,
                  phrase("1×classes×rows×columns with a class {}", input_.building_class));
  };
  if (output.dims != 4 || output.size[0] != 1 || output.type() != CV_32F) fail();
  const int classes = output.size[1];
  const int rows = output.size[2];
  const int columns = output.size[3];
  if (classes > kMostClasses || rows < 1 || columns < 1) fail();
  const int building = classes == 1 ? 0 : input_.building_class;
  if (building >= classes) fail();
  const auto pixels = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  const float* scores = output.ptr<float>();
  const bool are_shares = sumToOne(scores, classes, pixels);
  cv::Mat1f share(rows, columns);
  for (std::size_t i = 0; i < pixels; ++i) {
    const float score = scores[static_cast<std::size_t>(building) * pixels + i];
    float& result = *(share.ptr<float>() + i);
    if (are_shares) {
      result = score;
    } else if (classes == 1) {
      result = 1.0F / (1.0F + std::exp(-score));
    } else {
      double sum = 0.0;
      for (std::size_t c = 0; c < static_cast<std::size_t>(classes); ++c) {
        sum += std::exp(static_cast<double>(scores[c * pixels + i]) - static_cast<double>(score));
      }
      result = static_cast<float>(1.0 / sum);
    }
  }
  return share;
}

cv::Mat1f SegmentationNet::probabilities(const cv::Mat& image, const cv::Mat1b& /*wanted*/) const {
  const WindowGrid grid = WindowGrid::of(image.size());
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3) ||
      grid.count() == 0) {
    throwBadInput(phrase("image"), "",
                  phrase("{}×{} with {} channels", image.cols, image.rows, image.channels()),
                  phrase("8 bit, one or three channels, at least 16×16"));
  }
  const cv::Mat1f share = buildingShare(forward(image));
  cv::Mat1f pixels;
  cv::resize(share, pixels, image.size(), 0.0, 0.0, cv::INTER_LINEAR);
  cv::Mat1f windows;
  cv::resize(pixels(cv::Rect(0, 0, grid.columns * kWindow_px, grid.rows * kWindow_px)), windows,
             cv::Size(grid.columns, grid.rows), 0.0, 0.0, cv::INTER_AREA);
  if (!cv::checkRange(windows)) {
    throwBadInput(name_, "output", phrase("not a number"), phrase("scores"));
  }
  return windows;
}

}  // namespace handmap
