// Images and their labels in two folders.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/classification/window_labels.h"

namespace handmap {

/// Where labels are, and what they mean.
struct LabelledFolder {
  std::filesystem::path images;
  std::filesystem::path labels;
  int building = 1;            ///< the class number of buildings
  std::optional<int> ignored;  ///< of pixels that are not known
  int variations = 0;          ///< of each image, beside it
  std::uint64_t seed = 1;      ///< of the variations
};

/// Calls `use` with each image and its variations, in the order of the names. The labels of
/// NAME.jpg are NAME.png: grey, 8 bit, a class number a pixel. `share` of the images that are done
/// with it. Stops once `stop` is requested. Throws BadInput: no images, one without labels, one of
/// another size than its labels, or one that cannot be read.
void forEachLabelled(
    const LabelledFolder& folder,
    const std::function<void(const cv::Mat& image, const std::vector<WindowLabel>& labels,
                             double share)>& use,
    const std::stop_token& stop = {});

}  // namespace handmap
