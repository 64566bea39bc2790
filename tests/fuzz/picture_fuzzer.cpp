// Pictures under a drawing, GeoTIFFs foremost: their heads and pixels. The first byte is the kind.
#include <QString>
#include <array>
#include <cmath>
#include <fstream>

#include "tests/fuzz/fuzz.h"
#include "widgets/pictures/picture_file.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array kKinds = {"tif", "png", "jpg", "bmp", "gif", "webp"};
  if (size == 0) return 0;
  const auto path = std::filesystem::temp_directory_path() /
                    fmt::format("handmap-fuzz-{}.{}", getpid(), kKinds[data[0] % kKinds.size()]);
  std::ofstream(path, std::ios::binary) << fuzz::textOf(data + 1, size - 1);
  const QString name = QString::fromStdString(path.string());
  fuzz::takenOrRefused([&] {
    const PictureHead head = readPictureHead(name);
    fuzz::require(!head.size.isEmpty());
    if (!head.geometry) return;
    for (const PointPair& pair : head.geometry->pairs) {
      fuzz::require(pair.pixel.allFinite() && pair.point.allFinite());
    }
  });
  fuzz::takenOrRefused([&] { fuzz::require(!readPicture(name).image.isNull()); });
  std::filesystem::remove(path);
  return 0;
}
