#include "core/classification/load_classifier.h"

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/classification/building_classifier.h"
#include "core/classification/segmentation_net.h"

namespace handmap {

std::shared_ptr<const WindowClassifier> loadClassifier(const std::filesystem::path& path,
                                                       std::optional<int> building_class) {
  if (path.extension() == ".onnx") return SegmentationNet::load(path, building_class);
  if (building_class) {
    throw Error(ErrorCode::Usage, phrase("--building-class: only with --model NAME.onnx"));
  }
  return std::make_shared<const BuildingClassifier>(BuildingClassifier::load(path));
}

}  // namespace handmap
