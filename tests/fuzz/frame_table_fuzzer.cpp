// frames.csv: rows that are read are written and read again as many.
#include "core/recording/frame_table.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::takenOrRefused([&] {
    const auto rows = readFrameTable(fuzz::File(fuzz::textOf(data, size)).path());
    std::string text = frameTableHeader();
    for (const FrameRow& row : rows) text += formatFrameRow(row);
    fuzz::require(readFrameTable(fuzz::File(text).path()).size() == rows.size());
  });
}
