// Public maps and those of robots. The first byte is the kind; of a robot's, the text ends with the
// first zero, and the picture follows.
#include <array>
#include <fstream>

#include "core/geodata/geo_map.h"
#include "core/geodata/robot_map.h"
#include "core/map/map_io.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

namespace {

/// Drawings that can be saved and opened again.
void checkRead(const Map& map) {
  fuzz::require(!map.buildings.empty());
  parseMap(formatMap(map), "again");
}

void readRobots(std::string_view content, const std::filesystem::path& text) {
  const std::size_t end = content.find('\0');
  std::ofstream(text) << content.substr(0, end);
  std::ofstream(text.parent_path() / "map.pgm", std::ios::binary)
      << content.substr(std::min(content.size(), end == content.npos ? content.size() : end + 1));
  fuzz::takenOrRefused([&] { checkRead(readRobotMap(text)); });
  fuzz::takenOrRefused([&] { fuzz::require(!readRobotGrid(text).ground.edges.empty()); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array kKinds = {"geojson", "osm", "kml", "gml", "dxf", "gpkg", "shp", "yaml"};
  if (size == 0) return 0;
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("handmap-fuzz-{}", getpid());
  create_directories(folder);
  const auto path = folder / fmt::format("map.{}", kKinds[data[0] % kKinds.size()]);
  const std::string_view content = fuzz::textOf(data + 1, size - 1);
  if (path.extension() == ".yaml") {
    readRobots(content, path);
  } else {
    std::ofstream(path, std::ios::binary) << content;
    fuzz::takenOrRefused([&] { checkRead(readGeoMap(path).map); });
  }
  remove_all(folder);
  return 0;
}
