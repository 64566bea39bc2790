// Any classifier from its file.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/classification/window_classifier.h"

namespace handmap {

/// NAME.onnx: a SegmentationNet, else a BuildingClassifier; `building_class` is of networks alone.
/// Throws BadInput.
std::shared_ptr<const WindowClassifier> loadClassifier(const std::filesystem::path& path,
                                                       std::optional<int> building_class = {});

}  // namespace handmap
