// The taught building model that belongs to a map: the member "handmap:model" of its file, a path
// relative to the folder of the map.
#pragma once

#include <filesystem>
#include <optional>

#include "core/map/map.h"

namespace handmap {

/// Where the model of a map is; nullopt where the map names none. `map_file` is where the map comes
/// from. Throws BadInput "FILE: handmap:model: found …" for a member that is no path.
std::optional<std::filesystem::path> modelOf(const Map& map, const std::filesystem::path& map_file);
/// Names the model of a map that is, or will be, in `map_file`.
void setModel(Map& map, const std::filesystem::path& model, const std::filesystem::path& map_file);
/// NAME.model.json beside NAME.handmap.
std::filesystem::path modelBeside(const std::filesystem::path& map_file);

}  // namespace handmap
