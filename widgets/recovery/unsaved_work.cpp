#include "widgets/recovery/unsaved_work.h"

#include <QFile>
#include <QFileInfo>
#include <QObject>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/map/map_limits.h"

namespace handmap {

namespace {

constexpr int kVersion = 1;
constexpr std::uintmax_t kMaxBytes = 2 * kMaxMapBytes;  // as much again for what was painted
constexpr std::size_t kMaxPathBytes = 4096;

QString textOf(const JsonValue& json, const char* key) {
  return QString::fromStdString(json.textOr(key, kMaxPathBytes, ""));
}

}  // namespace

QString UnsavedWork::name() const {
  if (!project.isEmpty()) return QFileInfo(project).fileName();
  return map.name.empty() ? QObject::tr("Untitled") : QString::fromStdString(map.name);
}

std::string formatWork(const UnsavedWork& work) {
  const auto quoted = [](const QString& text) { return quotedJson(text.toStdString()); };
  return fmt::format(
      R"({{"format": "handmap-recovery", "version": {},
 "project": {}, "origin": {}, "written": {}, "modified": {},
 "teaching": {},
 "map": {}}}
)",
      kVersion, quoted(work.project), quoted(work.origin),
      quoted(work.written.toString(Qt::ISODate)), work.modified, formatTeaching(work.teaching),
      formatMap(work.map));
}

UnsavedWork readWork(const QString& file) {
  const std::string source = file.toStdString();
  const auto parsed = parseJson(readFile(QFile::encodeName(file).toStdString(), kMaxBytes), source);
  const JsonValue json(parsed, source);
  if (json.at("format").text(kMaxPathBytes) != "handmap-recovery") {
    json.at("format").fail("\"handmap-recovery\"");
  }
  json.at("version").integer(kVersion, kVersion);
  UnsavedWork work;
  work.project = textOf(json, "project");
  work.origin = textOf(json, "origin");
  work.written = QDateTime::fromString(textOf(json, "written"), Qt::ISODate);
  work.modified = json.at("modified").flag();
  work.teaching = readTeaching(json.at("teaching"));
  work.map = parseMap(json.at("map").dump(), source);
  return work;
}

}  // namespace handmap
