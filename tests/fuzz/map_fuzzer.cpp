// What is written of a map that was read comes back as the same bytes.
#include "core/map/issues.h"
#include "core/map/map_io.h"
#include "core/map/references.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::takenOrRefused([&] {
    const Map map = parseMap(fuzz::textOf(data, size), "map");
    const std::string written = formatMap(map);
    fuzz::require(formatMap(parseMap(written, "again")) == written);
    for (const Building& building : map.buildings) {
      fuzz::require(building.box().width >= 0.0);
    }
    checkReferences(map, "map");
    for (const Issue& issue : findIssues(map)) fuzz::require(!inWords(issue).empty());
    fuzz::require(parseMap(written, "again").layers == map.layers);
    formatGeoJson(map);
  });
}
