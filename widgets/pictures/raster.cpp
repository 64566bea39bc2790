#include "widgets/pictures/raster.h"

#include <QFile>
#include <QObject>
#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "core/base/error.h"

#ifdef HANDMAP_GDAL
#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>
#endif

namespace handmap::raster {

namespace {

[[noreturn]] void refuse(const QString& path, const QString& why) {
  throw Error(ErrorCode::BadInput, QStringLiteral("%1: %2").arg(path, why).toStdString());
}

}  // namespace

#ifdef HANDMAP_GDAL

namespace {

constexpr double kMaxPixels = 2e9;
constexpr int kMaxPairs = 100;

/// Only formats that are a picture in one file: others may name files and servers of their own.
void prepare() {
  static std::once_flag once;
  std::call_once(once, [] {
    CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR");
    CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
    GDALRegister_GTiff();
    GDALRegister_PNG();
    GDALRegister_JPEG();
    CPLSetErrorHandler(CPLQuietErrorHandler);
  });
}

struct Close {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, Close>;

struct Destroy {
  void operator()(void* system) const { OSRDestroySpatialReference(system); }
};
using System = std::unique_ptr<void, Destroy>;

Dataset open(const QString& path) {
  prepare();
  CPLErrorReset();
  Dataset dataset(GDALOpenEx(QFile::encodeName(path).constData(), GDAL_OF_RASTER | GDAL_OF_READONLY,
                             nullptr, nullptr, nullptr));
  if (!dataset || GDALGetRasterCount(dataset.get()) == 0) {
    const QString reason = QString::fromUtf8(CPLGetLastErrorMsg());
    refuse(path, reason.isEmpty() ? QObject::tr("no picture of a known format") : reason);
  }
  const double width = GDALGetRasterXSize(dataset.get());
  const double height = GDALGetRasterYSize(dataset.get());
  if (width * height > kMaxPixels)
    refuse(path, QObject::tr("%1 × %2 pixels are too many; cut out the place that is drawn")
                     .arg(width)
                     .arg(height));
  return dataset;
}

std::optional<std::vector<Vec2>> inDegrees(OGRSpatialReferenceH from,
                                           const std::vector<Vec2>& places) {
  const System degrees(OSRNewSpatialReference(nullptr));
  if (OSRImportFromEPSG(degrees.get(), 4326) != OGRERR_NONE) return std::nullopt;
  const System source(OSRClone(from));
  for (const auto* system : {&degrees, &source})
    OSRSetAxisMappingStrategy(system->get(), OAMS_TRADITIONAL_GIS_ORDER);
  auto* transformation = OCTNewCoordinateTransformation(source.get(), degrees.get());
  if (transformation == nullptr) return std::nullopt;
  std::vector<Vec2> result = places;
  bool good = true;
  for (Vec2& place : result) {
    good = good && OCTTransform(transformation, 1, &place.x(), &place.y(), nullptr) != 0 &&
           place.allFinite() && std::abs(place.x()) <= 180.0 && std::abs(place.y()) <= 90.0;
  }
  OCTDestroyCoordinateTransformation(transformation);
  return good ? std::optional(result) : std::nullopt;
}

std::vector<PointPair> cornersOf(GDALDatasetH dataset) {
  double affine[6];
  if (GDALGetGeoTransform(dataset, affine) != CE_None) return {};
  const double width = GDALGetRasterXSize(dataset);
  const double height = GDALGetRasterYSize(dataset);
  std::vector<PointPair> pairs;
  for (const Vec2& pixel : {Vec2(0, 0), Vec2(width, 0), Vec2(width, height), Vec2(0, height),
                            Vec2(width / 2.0, height / 2.0)}) {
    PointPair pair{pixel, {}};
    GDALApplyGeoTransform(affine, pixel.x(), pixel.y(), &pair.point.x(), &pair.point.y());
    pairs.push_back(pair);
  }
  return pairs;
}

std::vector<PointPair> controlPointsOf(GDALDatasetH dataset) {
  std::vector<PointPair> pairs;
  const GDAL_GCP* points = GDALGetGCPs(dataset);
  for (int i = 0; i < std::min(GDALGetGCPCount(dataset), kMaxPairs); ++i)
    pairs.push_back(
        {{points[i].dfGCPPixel, points[i].dfGCPLine}, {points[i].dfGCPX, points[i].dfGCPY}});
  return pairs;
}

std::optional<PictureGeometry> geometryOf(GDALDatasetH dataset) {
  PictureGeometry geometry{PictureGeometry::Kind::Metres, cornersOf(dataset)};
  OGRSpatialReferenceH system = GDALGetSpatialRef(dataset);
  if (geometry.pairs.empty()) {
    geometry.pairs = controlPointsOf(dataset);
    system = GDALGetGCPSpatialRef(dataset);
  }
  const auto is_finite = [](const PointPair& pair) {
    return pair.pixel.allFinite() && pair.point.allFinite();
  };
  if (geometry.pairs.size() < 2 || !std::ranges::all_of(geometry.pairs, is_finite))
    return std::nullopt;
  if (system == nullptr) return geometry;
  std::vector<Vec2> places;
  for (const PointPair& pair : geometry.pairs) places.push_back(pair.point);
  const auto degrees = inDegrees(system, places);
  if (!degrees) return geometry;
  geometry.kind = PictureGeometry::Kind::LongitudeLatitude;
  for (std::size_t i = 0; i < places.size(); ++i) geometry.pairs[i].point = (*degrees)[i];
  return geometry;
}

/// One channel into every fourth byte of the image; numbers of more than a byte are stretched from
/// the least to the greatest.
void readChannel(GDALRasterBandH band, QImage& image, int channel) {
  const int width = image.width();
  const int height = image.height();
  uchar* bytes = image.bits() + channel;
  const auto check = [](CPLErr error) {
    if (error != CE_None) throw Error(ErrorCode::BadInput, CPLGetLastErrorMsg());
  };
  const int whole_width = GDALGetRasterBandXSize(band);
  const int whole_height = GDALGetRasterBandYSize(band);
  if (GDALGetRasterDataType(band) == GDT_Byte) {
    return check(GDALRasterIO(band, GF_Read, 0, 0, whole_width, whole_height, bytes, width, height,
                              GDT_Byte, 4, static_cast<int>(image.bytesPerLine())));
  }
  std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  check(GDALRasterIO(band, GF_Read, 0, 0, whole_width, whole_height, values.data(), width, height,
                     GDT_Float32, 0, 0));
  double range[2] = {0.0, 255.0};
  GDALComputeRasterMinMax(band, TRUE, range);
  const double span = std::max(range[1] - range[0], 1e-12);
  for (int y = 0; y < height; ++y) {
    uchar* row = bytes + y * image.bytesPerLine();
    for (int x = 0; x < width; ++x) {
      const double value = values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x)];
      const double share = std::isfinite(value) ? (value - range[0]) / span : 0.0;
      row[4 * x] = static_cast<uchar>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
    }
  }
}

/// Numbers of colours become the colours.
void applyTable(GDALColorTableH table, QImage& image) {
  const int count = GDALGetColorEntryCount(table);
  for (int y = 0; y < image.height(); ++y) {
    uchar* row = image.scanLine(y);
    for (int x = 0; x < image.width(); ++x) {
      GDALColorEntry colour{};
      if (row[4 * x] < count) GDALGetColorEntryAsRGB(table, row[4 * x], &colour);
      const short channels[] = {colour.c1, colour.c2, colour.c3};
      for (int i = 0; i < 3; ++i) row[4 * x + i] = static_cast<uchar>(channels[i]);
    }
  }
}

}  // namespace

bool isAvailable() { return true; }

Info inspect(const QString& path) {
  const Dataset dataset = open(path);
  return {{GDALGetRasterXSize(dataset.get()), GDALGetRasterYSize(dataset.get())},
          geometryOf(dataset.get())};
}

QImage read(const QString& path, int max_side) {
  const Dataset dataset = open(path);
  QSize size(GDALGetRasterXSize(dataset.get()), GDALGetRasterYSize(dataset.get()));
  if (std::max(size.width(), size.height()) > max_side)
    size = size.scaled(max_side, max_side, Qt::KeepAspectRatio).expandedTo({1, 1});
  QImage image(size, QImage::Format_RGBA8888);
  if (image.isNull()) refuse(path, QObject::tr("there is not enough memory for it"));
  const int colours = GDALGetRasterCount(dataset.get()) >= 3 ? 3 : 1;
  const GDALRasterBandH first = GDALGetRasterBand(dataset.get(), 1);
  try {
    for (int channel = 0; channel < 3; ++channel)
      readChannel(GDALGetRasterBand(dataset.get(), std::min(channel, colours - 1) + 1), image,
                  channel);
    if (const GDALColorTableH table = GDALGetRasterColorTable(first); table != nullptr)
      applyTable(table, image);
    readChannel(GDALGetMaskBand(first), image, 3);
  } catch (const Error& error) {
    refuse(path, QString::fromUtf8(error.what()));
  }
  return image;
}

std::optional<std::vector<Vec2>> longitudesLatitudes(const QString& wkt,
                                                     const std::vector<Vec2>& places) {
  prepare();
  const System system(OSRNewSpatialReference(nullptr));
  QByteArray text = wkt.trimmed().toUtf8();
  char* rest = text.data();
  if (OSRImportFromWkt(system.get(), &rest) != OGRERR_NONE) return std::nullopt;
  return inDegrees(system.get(), places);
}

#else

bool isAvailable() { return false; }

Info inspect(const QString& path) {
  refuse(path, QObject::tr("this program was built without GDAL, which reads such pictures"));
}

QImage read(const QString& path, int) {
  refuse(path, QObject::tr("this program was built without GDAL, which reads such pictures"));
}

std::optional<std::vector<Vec2>> longitudesLatitudes(const QString&, const std::vector<Vec2>&) {
  return std::nullopt;
}

#endif

}  // namespace handmap::raster
