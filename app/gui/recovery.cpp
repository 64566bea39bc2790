#include "app/gui/recovery.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include "core/base/error.h"
#include "core/map/map_io.h"
#include "widgets/document/map_document.h"

namespace handmap {

namespace {
constexpr int kIntervalMs = 15'000;
constexpr auto kSettingsKey = "recovery/files";
constexpr QLatin1String kSuffix(".recovery");
}  // namespace

Recovery::Recovery(MapDocument& document, QSettings& settings, QObject* parent)
    : QObject(parent), document_(document), settings_(settings) {
  connect(&document_, &MapDocument::mapChanged, this, [this] { dirty_ = true; });
  timer_.setInterval(kIntervalMs);
  connect(&timer_, &QTimer::timeout, this, &Recovery::write);
  timer_.start();
}

QString Recovery::fileFor(const QString& project) {
  if (!project.isEmpty()) return project + kSuffix;
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
         QStringLiteral("/untitled.handmap") + kSuffix;
}

QStringList Recovery::leftBehind() const {
  QStringList files = settings_.value(kSettingsKey).toStringList();
  files.removeIf([this](const QString& file) { return file == written_ || !QFile::exists(file); });
  return files;
}

void Recovery::recover(const QString& file) {
  Map map = readMap(file.toStdString());
  QString project = file.chopped(kSuffix.size());
  if (file == fileFor({})) project.clear();
  document_.reset(std::move(map), project);
  document_.undoStack().resetClean();
  written_ = file;
}

void Recovery::forget(const QString& file) {
  QFile::remove(file);
  QStringList files = settings_.value(kSettingsKey).toStringList();
  files.removeAll(file);
  settings_.setValue(kSettingsKey, files);
}

void Recovery::clear() {
  if (!written_.isEmpty()) forget(written_);
  written_.clear();
  dirty_ = false;
}

void Recovery::remember(const QString& file) {
  QStringList files = settings_.value(kSettingsKey).toStringList();
  files.removeAll(file);
  files.prepend(file);
  settings_.setValue(kSettingsKey, files);
  settings_.sync();
}

bool Recovery::write() {
  if (!dirty_ || !document_.isModified()) return true;
  const QString file = fileFor(document_.filePath());
  try {
    QDir().mkpath(QFileInfo(file).path());
    writeMap(document_.map(), file.toStdString());
  } catch (const Error&) {
    return false;  // e.g. a folder without write permission: saving will say so
  }
  remember(file);
  written_ = file;
  dirty_ = false;
  return true;
}

}  // namespace handmap
