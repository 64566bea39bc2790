// A network that segments whole images, in ONNX form, in the place of the window classifier.
#pragma once

#include <array>
#include <filesystem>
#include <mutex>
#include <optional>

#include <opencv2/core/types.hpp>
#include <opencv2/dnn/dnn.hpp>

#include "core/classification/window_classifier.h"

namespace handmap {

/// What is fed: (value / 255 - mean) / deviation, red first; the defaults are those of networks
/// that were trained with torchvision's weights.
struct SegmentationInput {
  int building_class = 0;        ///< of the network's output
  std::optional<cv::Size> size;  ///< that it insists on; else that of the image, up to a whole 32
  std::array<double, 3> mean = {0.485, 0.456, 0.406};
  std::array<double, 3> deviation = {0.229, 0.224, 0.225};
};

class SegmentationNet : public WindowClassifier {
 public:
  /// Beside NET.onnx may lie NET.json: {"building_class": n, "width": w, "height": h, "mean": [r,
  /// g, b], "deviation": [r, g, b]}, each optional. `building_class`, where it is given, goes
  /// before. Throws BadInput: no network, without a class for buildings, or with an output that is
  /// not one score (or one number from 0 to 1) a class and pixel.
  static std::shared_ptr<const SegmentationNet> load(const std::filesystem::path& path,
                                                     std::optional<int> building_class = {});
  SegmentationNet(std::string name, const cv::dnn::Net& net, const SegmentationInput& input);

  cv::Mat1f probabilities(const cv::Mat& image, const cv::Mat1b& wanted = {}) const override;

 private:
  cv::Mat forward(const cv::Mat& image) const;
  cv::Mat1f buildingShare(const cv::Mat& output) const;

  std::string name_;
  SegmentationInput input_;
  mutable std::mutex mutex_;  // a network holds its buffers
  mutable cv::dnn::Net net_;
};

}  // namespace handmap
