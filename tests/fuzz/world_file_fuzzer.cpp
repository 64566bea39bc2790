// World files: whatever is taken places every pixel, and a picture can be laid by it or not.
#include "core/map/underlay_fit.h"
#include "core/map/world_file.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::takenOrRefused([&] {
    const WorldFile file = parseWorldFile(fuzz::textOf(data, size), "world");
    PictureGeometry geometry;
    for (const Vec2& pixel : {Vec2(0, 0), Vec2(640, 0), Vec2(640, 480), Vec2(0, 480)})
      geometry.pairs.push_back({pixel, file.placeOf(pixel)});
    for (const auto kind :
         {PictureGeometry::Kind::Metres, PictureGeometry::Kind::LongitudeLatitude}) {
      geometry.kind = kind;
      const auto placed = grounded({}, geometry, std::nullopt, Vec2::Zero());
      fuzz::require(!placed || placed->fit.underlay.metres_per_pixel > 0.0);
    }
  });
}
