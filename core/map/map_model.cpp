#include "core/map/map_model.h"

#include "core/base/error.h"
#include "core/base/json.h"

namespace handmap {

namespace {

constexpr auto kKey = "handmap:model";
constexpr std::size_t kMaxPath = 4096;

/// Files without a folder lie in the working one.
std::filesystem::path folderOf(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).lexically_normal().parent_path();
}

}  // namespace

std::optional<std::filesystem::path> modelOf(const Map& map,
                                             const std::filesystem::path& map_file) {
  const auto member = map.unknown.find(kKey);
  if (member == map.unknown.end()) return std::nullopt;
  const nlohmann::json members{{kKey, parseJson(member->second, map_file.string())}};
  const JsonValue value = JsonValue(members, map_file.string()).at(kKey);
  const std::string path = value.text(kMaxPath);
  if (path.empty()) value.fail("a path relative to the folder of the map");
  return map_file.parent_path() / path;
}

void setModel(Map& map, const std::filesystem::path& model, const std::filesystem::path& map_file) {
  const std::filesystem::path absolute = std::filesystem::absolute(model).lexically_normal();
  const std::filesystem::path relative = absolute.lexically_relative(folderOf(map_file));
  map.unknown[kKey] = quotedJson((relative.empty() ? absolute : relative).generic_string());
}

void moveModel(Map& map, const std::filesystem::path& from_file,
               const std::filesystem::path& to_file) {
  if (folderOf(from_file) == folderOf(to_file)) return;
  try {
    if (const auto model = modelOf(map, from_file)) setModel(map, *model, to_file);
  } catch (const Error&) {  // whoever wants to use it is told
  }
}

std::filesystem::path modelBeside(const std::filesystem::path& map_file) {
  return map_file.parent_path() / (map_file.stem().string() + ".model.json");
}

}  // namespace handmap
