#include "widgets/recovery/recovery.h"

#include <QDir>
#include <QFileInfo>
#include <QLockFile>
#include <QSettings>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "widgets/document/map_document.h"
#include "widgets/teach/teach_panel.h"

namespace handmap {

namespace {

constexpr auto kGroup = "recovery_sessions";

QString keyOf(const QString& session) { return QLatin1String(kGroup) + QLatin1Char('/') + session; }

std::shared_ptr<QLockFile> lockOf(const QString& file) {
  auto lock = std::make_shared<QLockFile>(file + QStringLiteral(".lock"));
  lock->setStaleLockTime(0);  // by the process that is gone, never by age
  return lock;
}

/// Empty: none is there.
QString newestOf(const QStringList& files) {
  QFileInfo newest;
  for (const QString& file : files) {
    const QFileInfo info(file);
    if (!info.exists()) continue;
    if (!newest.exists() || info.lastModified() > newest.lastModified()) newest = info;
  }
  return newest.filePath();
}

}  // namespace

Recovery::Recovery(MapDocument& document, TeachPanel& teach, QSettings& settings,
                   RecoveryOptions options, QObject* parent)
    : QObject(parent),
      document_(document),
      teach_(teach),
      settings_(settings),
      options_(std::move(options)),
      session_(QUuid::createUuid().toString(QUuid::Id128).left(12)) {
  pool_.setMaxThreadCount(1);
  timer_.setSingleShot(true);
  timer_.setInterval(options_.delay_ms);
  connect(&timer_, &QTimer::timeout, this, &Recovery::write);
  connect(&document_, &MapDocument::mapChanged, this, &Recovery::onChange);
  connect(&document_, &MapDocument::fileChanged, this, &Recovery::onChange);
  connect(&teach_, &TeachPanel::teachingChanged, this, &Recovery::onChange);
}

Recovery::~Recovery() { pool_.waitForDone(); }

QStringList RecoveryOptions::usualFolders() {
  return {QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
              QStringLiteral("/recovery"),
          QDir::tempPath()};
}

bool Recovery::hasUnsavedWork() const { return document_.isModified() || teach_.hasUnsavedWork(); }

void Recovery::onChange() {
  if (!hasUnsavedWork()) return clear();
  if (!timer_.isActive()) timer_.start();  // not anew: who draws without a rest is written too
}

QStringList Recovery::candidates() const {
  const QFileInfo project(document_.filePath());
  QStringList folders = options_.folders;
  if (!project.filePath().isEmpty()) folders.prepend(project.absolutePath());
  const QString name =
      project.filePath().isEmpty() ? QStringLiteral("untitled.handmap") : project.fileName();
  QStringList files;
  for (const QString& folder : folders) {
    files << QStringLiteral("%1/%2.%3.recovery").arg(folder, name, session_);
  }
  return files;
}

void Recovery::write() {
  const MapDocument& document = document_;
  UnsavedWork work{document.filePath(),   document.origin(), QDateTime::currentDateTimeUtc(),
                   document.isModified(), document.map(),    teach_.teaching()};
  const QStringList files = candidates();
  for (const QString& file : files) {
    if (!places_.contains(file)) places_ << file;
  }
  tellSettings();  // before the file is there: who is killed in between is asked about it too
  pool_.start([this, files, work = std::move(work)] {
    const Outcome outcome = writeTo(files, work);
    QMetaObject::invokeMethod(this, [this, outcome] { onWritten(outcome); });
  });
}

void Recovery::tellSettings() {
  if (places_.isEmpty() || settings_.value(keyOf(session_)) == places_) return;
  settings_.setValue(keyOf(session_), places_);
  settings_.sync();
}

Recovery::Outcome Recovery::writeTo(const QStringList& files, const UnsavedWork& work) {
  Outcome outcome;
  QStringList in_turn = files;
  if (!place_.file.isEmpty()) in_turn.prepend(place_.file);
  for (const QString& file : std::as_const(in_turn)) {
    try {
      Place place = place_;
      if (file != place.file) {
        // The folder of a project may be on a disk that is gone: it is not made anew there.
        const QString folder = QFileInfo(file).path();
        if (options_.folders.contains(folder)) QDir().mkpath(folder);
        place = {file, lockOf(file)};
        place.lock->tryLock(0);
      }
      writeFileAtomically(QFile::encodeName(file).toStdString(), formatWork(work));
      if (!place_.file.isEmpty() && file != place_.file) QFile::remove(place_.file);
      place_ = place;
      outcome.file = file;
      return outcome;
    } catch (const std::exception& error) {
      if (outcome.problem.isEmpty()) outcome.problem = QString::fromUtf8(error.what());
    }
  }
  return outcome;
}

void Recovery::onWritten(const Outcome& outcome) {
  tellSettings();  // a window that looked in between may have forgotten what was not there
  if (outcome.problem.isEmpty()) return;
  if (!std::exchange(outcome.file.isEmpty() ? told_nowhere_ : told_instead_, true)) {
    Q_EMIT cannotKeep(outcome.problem, outcome.file);
  }
}

void Recovery::clear() {
  timer_.stop();
  if (places_.isEmpty()) return;
  pool_.start([this, places = std::exchange(places_, {})] {
    for (const QString& file : places) QFile::remove(file);
    place_ = {};
  });
  settings_.remove(keyOf(session_));
  settings_.sync();
}

std::vector<LeftBehind> Recovery::takeLeftBehind() {
  QSettings& settings = settings_;
  settings.sync();
  std::vector<LeftBehind> result;
  settings.beginGroup(kGroup);
  for (const QString& session : settings.childKeys()) {
    if (session == session_) continue;
    const QStringList places = settings.value(session).toStringList();
    const QString file = newestOf(places);
    if (file.isEmpty()) {
      // What lies on a disk that is not there at the moment is not forgotten.
      const auto is_there = [&](const QString& place) {
        const QDir folder = QFileInfo(place).dir();
        return options_.folders.contains(folder.path()) || folder.exists();
      };
      if (std::ranges::all_of(places, is_there)) settings.remove(session);
      continue;
    }
    auto lock = lockOf(file);
    if (!lock->tryLock(0) && lock->error() == QLockFile::LockFailedError) continue;  // it lives
    result.push_back({session, file, places, std::move(lock)});
  }
  settings.endGroup();
  return result;
}

void Recovery::recover(const LeftBehind& left, const UnsavedWork& work) {
  MapDocument& document = document_;
  if (!work.modified && !work.project.isEmpty()) {
    document.open(work.project);
  } else {
    document.reset(work.map, work.project, work.origin);
    if (work.modified) document.undoStack().resetClean();
  }
  clear();  // what was here before has been asked for
  session_ = left.session;
  places_ = left.places;
  pool_.start([this, left] { place_ = {left.file, left.lock}; });
  teach_.addTeaching(work.teaching);
  onChange();
}

void Recovery::forget(const LeftBehind& left) {
  for (const QString& file : left.places) QFile::remove(file);
  settings_.remove(keyOf(left.session));
  settings_.sync();
}

}  // namespace handmap
