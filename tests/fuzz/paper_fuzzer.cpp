// Photos of drawings, and what a map keeps of the handwriting on them.
#include "core/paper/handwriting.h"
#include "core/paper/traced_map.h"
#include "core/recording/image_file.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

namespace {

constexpr int kMostSide_px = 400;  // larger ones find no more, and less often

/// So many pixels a row, the rest as it comes: whatever was drawn.
void readPixels(const std::uint8_t* data, std::size_t size) {
  const int width = data[0] + 1;
  const int height = static_cast<int>(size - 1) / width;
  if (height == 0) return;
  cv::Mat page(height, width, CV_8U);
  std::copy_n(data + 1, page.total(), page.data);
  const Trace trace = traced(page);
  for (const TracedShape& shape : trace.shapes) fuzz::require(shape.outline.size() >= 3);
  mapOf(trace, placeOfDrawing(trace, sureShapes(trace), 100.0));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::takenOrRefused([&] {
    Building building;
    building.unknown[kWritingKey] = std::string(fuzz::textOf(data, size));
    const cv::Mat ink = writingOf(building);
    fuzz::require(ink.cols <= kWritingWidth_px && ink.rows <= kWritingHeight_px);
    if (size > 1) readPixels(data, size);
    const cv::Mat photo = decodePhoto(fuzz::textOf(data, size), "photo", kPhotoSide_px);
    if (std::max(photo.cols, photo.rows) > kMostSide_px) return;
    const Trace trace = traced(photo);
    mapOf(trace, placeOfDrawing(trace, sureShapes(trace), 100.0));
    troubleWith(photo);
  });
}
