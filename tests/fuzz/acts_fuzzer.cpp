// acts.jsonl: what was read comes back the same.
#include <fstream>

#include "core/session/acts.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::TemporaryFolder kFolder;
  kFolder.write(kActsFile, fuzz::textOf(data, size));
  return fuzz::takenOrRefused([&] {
    const std::vector<Act> acts = readActs(kFolder.path());
    writeActs(kFolder.path(), acts);
    fuzz::require(readActs(kFolder.path()).size() == acts.size());
  });
}
