#include "core/map/references.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/phrase.h"
#include "core/map/map_limits.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

/// Files without a folder lie in the working one.
fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Links followed as far as the path exists; empty where they cannot be (a ring of links).
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error) return {};
  return canonical.has_filename() ? canonical : canonical.parent_path();
}

/// Links not followed, relative ones from the working folder; without one they stay relative.
fs::path absolutePath(const fs::path& path) {
  std::error_code error;
  return (fs::current_path(error) / path).lexically_normal();
}

bool isBelow(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

}  // namespace

std::optional<Reference> modelReference(const Map& map, const fs::path& map_file) {
  if (!map.model.empty()) return Reference{kModelKey, map.model};
  const auto damaged = map.unknown.find(kModelKey);
  if (damaged == map.unknown.end()) return std::nullopt;
  throwBadInput(map_file.string(), kModelKey, damaged->second,
                phrase("a path relative to the folder of the map"));
}

fs::path modelBeside(const fs::path& map_file) {
  return map_file.parent_path() / (map_file.stem().string() + ".model.json");
}

std::vector<Reference> referencesOf(const Map& map, const fs::path& map_file) {
  std::vector<Reference> references;
  for (std::size_t i = 0; i < map.underlays.size(); ++i) {
    references.push_back({fmt::format("underlays[{}].image", i), map.underlays[i].image});
  }
  if (const auto model = modelReference(map, map_file)) references.push_back(*model);
  return references;
}

fs::path targetOf(const Reference& reference, const fs::path& map_file) {
  return map_file.parent_path() / reference.path;
}

std::string referenceFrom(const fs::path& map_file, const fs::path& target) {
  const fs::path absolute = absolutePath(target);
  const fs::path relative = absolute.lexically_relative(absolutePath(map_file).parent_path());
  return (relative.empty() ? absolute : relative).generic_string();
}

void moveReferences(Map& map, const fs::path& from_file, const fs::path& to_file) {
  if (from_file.empty() ||
      absolutePath(from_file).parent_path() == absolutePath(to_file).parent_path()) {
    return;
  }
  const auto moved = [&](const Reference& reference) {
    return reference.path.is_absolute() ? reference.path.string()
                                        : referenceFrom(to_file, targetOf(reference, from_file));
  };
  for (Underlay& underlay : map.underlays) underlay.image = moved({"image", underlay.image});
  if (!map.model.empty()) map.model = moved({kModelKey, map.model});
}

bool staysInside(const Reference& reference, const fs::path& map_file) {
  const fs::path folder = resolved(folderOf(map_file));
  const fs::path target = resolved(targetOf(reference, map_file));
  return !folder.empty() && !target.empty() && target != folder && isBelow(target, folder);
}

void checkReference(const Reference& reference, const fs::path& map_file, Outside outside) {
  const auto refuse = [&](const std::string& what, const std::string& expected,
                          const std::string& hint) {
    throw Error(ErrorCode::BadInput,
                phrase("{}: {}: found {}{}, expected {}", map_file.string(), reference.key,
                       quotedJson(reference.path.string()), what, expected),
                hint);
  };
  if (reference.path.string().find('\0') != std::string::npos) {
    refuse("", phrase("the path of a file"), "");
  }
  if (outside == Outside::Refused && !staysInside(reference, map_file)) {
    refuse(phrase(", outside of the folder of the map"), phrase("a file in that folder"),
           phrase("put it beside the map, or allow what lies outside (--allow-outside) if you "
                  "trust the map"));
  }
  std::error_code error;
  const fs::file_status status = fs::status(targetOf(reference, map_file), error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    refuse(phrase(", which is no regular file"), phrase("a file"), "");
  }
}

void checkReferences(const Map& map, const fs::path& map_file, Outside outside) {
  for (const Reference& reference : referencesOf(map, map_file)) {
    checkReference(reference, map_file, outside);
  }
}

}  // namespace handmap
