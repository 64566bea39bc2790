#include "core/map/map_model.h"

#include "core/base/json.h"
#include "core/map/references.h"

namespace handmap {

std::optional<std::filesystem::path> modelOf(const Map& map,
                                             const std::filesystem::path& map_file) {
  const auto reference = modelReference(map, map_file);
  if (!reference) return std::nullopt;
  return targetOf(*reference, map_file);
}

void setModel(Map& map, const std::filesystem::path& model, const std::filesystem::path& map_file) {
  map.model = referenceFrom(map_file, model);
}

std::filesystem::path modelBeside(const std::filesystem::path& map_file) {
  return map_file.parent_path() / (map_file.stem().string() + ".model.json");
}

}  // namespace handmap
