// rig.json: a rig that was read comes back as the same rig.
#include "core/rig/rig.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::takenOrRefused([&] {
    const Rig rig = parseRig(std::string(fuzz::textOf(data, size)), "rig.json", "/rigs");
    fuzz::require(parseRig(formatRig(rig, "/rigs"), "again", "/rigs") == rig);
  });
}
