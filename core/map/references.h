// The files that a map names beside itself: pictures under the drawing and the taught model. What
// somebody else's drawing names may not lead out of its folder unless the person allows it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/map/map.h"

namespace handmap {

struct Reference {
  std::string key;             ///< "underlays[0].image", "handmap:model"
  std::filesystem::path path;  ///< as the map has it: absolute, or relative to the map's folder
};

/// The member of a map that names its taught model.
inline constexpr auto kModelKey = "handmap:model";

enum class Outside { Refused, Allowed };

/// Throws BadInput for a member that is no path. `map_file` names the map in messages.
std::optional<Reference> modelReference(const Map& map, const std::filesystem::path& map_file);
/// NAME.model.json beside NAME.handmap.
std::filesystem::path modelBeside(const std::filesystem::path& map_file);
/// That of the pictures and of the model. Throws BadInput for a model that is no path.
std::vector<Reference> referencesOf(const Map& map, const std::filesystem::path& map_file);

/// Where a reference of a map that is, or will be, in `map_file` leads, its links not followed.
std::filesystem::path targetOf(const Reference& reference, const std::filesystem::path& map_file);

/// `target` as a map in `map_file` names it: relative to the folder of the map.
std::string referenceFrom(const std::filesystem::path& map_file,
                          const std::filesystem::path& target);

/// Relative paths as seen from another file. Those of a map that came from no file (empty
/// `from_file`) and a model that is no path stay as they are.
void moveReferences(Map& map, const std::filesystem::path& from_file,
                    const std::filesystem::path& to_file);

/// Whether it leads, links followed, to a place in or below the folder of `map_file`. The folder
/// may itself be a link; the target need not be there.
bool staysInside(const Reference& reference, const std::filesystem::path& map_file);

/// Throws BadInput "MAP_FILE: KEY: found …, expected …" for one that leaves the folder, unless that
/// is allowed, or that leads to something else than a regular file (a folder, a pipe, a device). A
/// file that is not there is left to whoever opens it.
void checkReference(const Reference& reference, const std::filesystem::path& map_file,
                    Outside outside = Outside::Refused);

/// All of them.
void checkReferences(const Map& map, const std::filesystem::path& map_file,
                     Outside outside = Outside::Refused);

}  // namespace handmap
