#include "app/gui/run/recording_settings.h"

#include <QDir>
#include <QStringList>

namespace handmap {

namespace {

constexpr auto kRecordingsKey = "run/recordings";
constexpr qsizetype kMostRecordings = 50;
constexpr int kFields = 5;  // from, to, every, kind, folder
constexpr int kToEnd = -1;

QString entryOf(const QString& folder, const ReplayOptions& options) {
  return QStringLiteral("%1 %2 %3 %4 %5")
      .arg(options.from)
      .arg(options.to.value_or(kToEnd))
      .arg(options.every)
      .arg(static_cast<int>(options.kind))
      .arg(folder);
}

QString folderOf(const QString& entry) { return entry.section(QLatin1Char(' '), kFields - 1); }

bool isDefault(const ReplayOptions& options) {
  return options.from == 0 && !options.to && options.every == 1 && options.kind == SourceKind::Auto;
}

}  // namespace

ReplayOptions settingsOfRecording(const QSettings& settings, const QString& folder) {
  const QString cleaned = QDir::cleanPath(folder);
  for (const QString& entry : settings.value(kRecordingsKey).toStringList()) {
    if (folderOf(entry) != cleaned) continue;
    const auto number = [&](int field, int least, int most, int otherwise) {
      bool is_number = false;
      const int value = entry.section(QLatin1Char(' '), field, field).toInt(&is_number);
      return is_number && value >= least && value <= most ? value : otherwise;
    };
    ReplayOptions options;
    options.from = number(0, 0, std::numeric_limits<int>::max(), 0);
    const int to = number(1, 0, std::numeric_limits<int>::max(), kToEnd);
    if (to != kToEnd) options.to = to;
    options.every = number(2, 1, std::numeric_limits<int>::max(), 1);
    options.kind = static_cast<SourceKind>(number(3, 0, static_cast<int>(SourceKind::Points), 0));
    return options;
  }
  return {};
}

void keepSettingsOfRecording(QSettings& settings, const QString& folder,
                             const ReplayOptions& options) {
  const QString cleaned = QDir::cleanPath(folder);
  QStringList entries = settings.value(kRecordingsKey).toStringList();
  entries.removeIf([&](const QString& entry) { return folderOf(entry) == cleaned; });
  if (!isDefault(options)) entries.prepend(entryOf(cleaned, options));
  settings.setValue(kRecordingsKey, entries.mid(0, kMostRecordings));
}

}  // namespace handmap
