#include "widgets/pictures/picture_file.h"

#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <QObject>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/map/world_file.h"
#include "widgets/pictures/raster.h"

namespace handmap {

namespace {

constexpr int kMaxSide = 6000;  // pixels; larger pictures are read smaller
constexpr std::uintmax_t kMaxWorldFile = 4096;
constexpr std::uintmax_t kMaxProjectionFile = 65536;

std::filesystem::path native(const QString& path) { return QFile::encodeName(path).toStdString(); }

[[noreturn]] void refuse(const QString& path, const QString& why) {
  throw Error(ErrorCode::BadInput, QStringLiteral("%1: %2").arg(path, why).toStdString());
}

QStringList suffixes() {
  QStringList all = {QStringLiteral("png"), QStringLiteral("jpg"), QStringLiteral("jpeg"),
                     QStringLiteral("bmp"), QStringLiteral("gif"), QStringLiteral("webp")};
  if (raster::isAvailable()) all << QStringLiteral("tif") << QStringLiteral("tiff");
  return all;
}

/// One could wait for a pipe for ever.
void requireFile(const QString& path) {
  if (!QFileInfo(path).isFile())
    refuse(path, QFileInfo::exists(path) ? QObject::tr("not a file") : QObject::tr("no such file"));
}

bool isForRasters(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return suffix == QLatin1String("tif") || suffix == QLatin1String("tiff");
}

/// Where Qt can read it with the memory that it allows itself.
bool isForQt(const QImageReader& reader) {
  constexpr double kBytesPerPixel = 4.0;
  constexpr double kMegabyte = 1024.0 * 1024.0;
  const QSize size = reader.size();
  const double limit = QImageReader::allocationLimit() * kMegabyte;
  return limit == 0.0 || kBytesPerPixel * size.width() * size.height() <= limit;
}

/// "a.jpg": "a.jgw", "a.jpgw", "a.wld"; empty: there is none.
QString worldFileBeside(const QString& path) {
  const QFileInfo info(path);
  const QString suffix = info.suffix().toLower();
  const QStringList names = {
      info.completeBaseName() + u'.' + suffix.left(1) + suffix.right(1) + u'w',
      info.completeBaseName() + u'.' + suffix + u'w',
      info.completeBaseName() + QStringLiteral(".wld")};
  const QStringList beside = info.absoluteDir().entryList(QDir::Files);
  for (const QString& name : names)
    for (const QString& file : beside)
      if (file.compare(name, Qt::CaseInsensitive) == 0) return info.absoluteDir().filePath(file);
  return {};
}

QString projectionBeside(const QString& path) {
  const QFileInfo info(path);
  const QString file =
      info.absoluteDir().filePath(info.completeBaseName() + QStringLiteral(".prj"));
  if (!QFileInfo(file).isFile()) return {};
  return QString::fromStdString(readFile(native(file), kMaxProjectionFile));
}

/// Places that could be degrees, with pixels far below a metre if they were metres, are degrees.
bool looksLikeDegrees(const WorldFile& file) {
  return file.per_pixel.cwiseAbs().maxCoeff() < 1e-3 && std::abs(file.first.x()) <= 180.0 &&
         std::abs(file.first.y()) <= 90.0;
}

std::optional<PictureGeometry> geometryBeside(const QString& path, const QSize& size) {
  const QString world = worldFileBeside(path);
  if (world.isEmpty()) return std::nullopt;
  const WorldFile file =
      parseWorldFile(readFile(native(world), kMaxWorldFile), world.toStdString());
  const double width = size.width();
  const double height = size.height();
  PictureGeometry geometry;
  std::vector<Vec2> places;
  for (const Vec2& pixel : {Vec2(0, 0), Vec2(width, 0), Vec2(width, height), Vec2(0, height)}) {
    geometry.pairs.push_back({pixel, file.placeOf(pixel)});
    places.push_back(geometry.pairs.back().point);
  }
  const QString system = projectionBeside(path);
  if (system.isEmpty() && looksLikeDegrees(file)) {
    geometry.kind = PictureGeometry::Kind::LongitudeLatitude;
    return geometry;
  }
  const auto degrees = raster::longitudesLatitudes(system, places);
  if (!degrees) return geometry;
  geometry.kind = PictureGeometry::Kind::LongitudeLatitude;
  for (std::size_t i = 0; i < places.size(); ++i) geometry.pairs[i].point = (*degrees)[i];
  return geometry;
}

Picture readRaster(const QString& path) {
  return {raster::read(path, kMaxSide), raster::inspect(path).size};
}

}  // namespace

QString pictureEndings() { return QStringLiteral("*.") + suffixes().join(QStringLiteral(" *.")); }

QString pictureFilter() { return QObject::tr("Pictures (%1)").arg(pictureEndings()); }

bool isPictureName(const QString& path) {
  return suffixes().contains(QFileInfo(path).suffix().toLower());
}

PictureHead readPictureHead(const QString& path) {
  requireFile(path);
  const QImageReader reader(path);
  PictureHead head;
  if (isForRasters(path) || !isForQt(reader)) {
    const raster::Info info = raster::inspect(path);
    head = {info.size, info.geometry};
  } else {
    head.size = reader.size();
    if (!reader.canRead() || !head.size.isValid())
      refuse(path, QObject::tr("no picture, or one of an unknown format"));
  }
  if (head.size.isEmpty()) refuse(path, QObject::tr("a picture without pixels"));
  if (!head.geometry) head.geometry = geometryBeside(path, head.size);
  return head;
}

Picture readPicture(const QString& path) {
  requireFile(path);
  QImageReader reader(path);
  if (isForRasters(path) || !isForQt(reader)) return readRaster(path);
  Picture picture{{}, reader.size()};
  if (picture.size.width() > kMaxSide || picture.size.height() > kMaxSide)
    reader.setScaledSize(picture.size.scaled(kMaxSide, kMaxSide, Qt::KeepAspectRatio));
  picture.image = reader.read();
  if (picture.image.isNull()) refuse(path, reader.errorString());
  if (!picture.size.isValid()) picture.size = picture.image.size();
  return picture;
}

}  // namespace handmap
