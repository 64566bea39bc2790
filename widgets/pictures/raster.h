// Rasters of surveyors (GeoTIFF), and pictures too large to be read at once. Through GDAL, and only
// here; a program that was built without it refuses them.
#pragma once

#include <QImage>
#include <optional>

#include "core/map/underlay_fit.h"

namespace handmap::raster {

/// Whether this program was built with GDAL.
bool isAvailable();

struct Info {
  QSize size;
  std::optional<PictureGeometry> geometry;
};

/// The head of the file alone. Throws Error (BadInput) for what is no picture or has more pixels
/// than could be read in a bearable time.
Info inspect(const QString& path);

/// Not larger than `max_side`; what has no data is transparent. Throws Error (BadInput).
QImage read(const QString& path, int max_side);

/// Places in a coordinate system (as .prj files describe it) as longitude and latitude. nullopt: it
/// is not known, or without GDAL.
std::optional<std::vector<Vec2>> longitudesLatitudes(const QString& wkt,
                                                     const std::vector<Vec2>& places);

}  // namespace handmap::raster
