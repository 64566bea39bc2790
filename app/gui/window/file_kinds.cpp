#include "app/gui/window/file_kinds.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUrl>

#include "app/gui/editing/robot_map_layer.h"
#include "app/gui/run/source_actions.h"
#include "core/bags/bag.h"
#include "core/geodata/geo_map.h"
#include "core/kitti_raw/kitti_raw.h"
#include "widgets/pictures/picture_file.h"

namespace handmap {

namespace {

constexpr qint64 kBeginning = 4096;  // bytes

bool begins(const QString& path, const char* word) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) && file.read(kBeginning).contains(word);
}

FileKind folderKindOf(const QString& path) {
  const std::filesystem::path folder = QFile::encodeName(path).toStdString();
  const QDir files(path);
  const bool is_own = files.exists("recording.json") || files.exists("frames.csv");
  return !is_own && (isBag(folder) || isKittiRaw(folder)) ? FileKind::Log : FileKind::Recording;
}

}  // namespace

FileKind fileKindOf(const QString& path) {
  const QFileInfo info(path);
  if (info.isDir()) return folderKindOf(path);
  const std::filesystem::path file = QFile::encodeName(path).toStdString();
  const QString ending = info.suffix().toLower();
  if (ending == QLatin1String("handmap")) return FileKind::Drawing;
  if (isPictureName(path) || RobotMapLayer::isRobotMap(path)) return FileKind::Picture;
  if (ending == QLatin1String("json") && begins(path, "\"handmap-rig\"")) return FileKind::Rig;
  if (isGeoFile(file)) return FileKind::Drawing;
  return SourceActions::logEndings().contains(ending) ? FileKind::Log : FileKind::Unknown;
}

QString draggedPath(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  if (urls.size() != 1 || !urls.front().isLocalFile()) return {};
  const QString path = urls.front().toLocalFile();
  return fileKindOf(path) != FileKind::Unknown ? path : QString();
}

}  // namespace handmap
