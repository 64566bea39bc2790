#include "app/gui/files/disk_watch.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include "app/gui/files/file_actions.h"
#include "app/gui/shell/message_bar.h"
#include "widgets/document/map_document.h"

namespace handmap {

namespace {
constexpr int kSettledMs = 300;  // who writes a file writes it in several goes
constexpr auto kDiskWatchTopic = "changed_on_disk";
}  // namespace

DiskWatch::DiskWatch(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
  timer_.setSingleShot(true);
  timer_.setInterval(kSettledMs);
  connect(&timer_, &QTimer::timeout, this, &DiskWatch::look);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &timer_, qOverload<>(&QTimer::start));
  connect(&parts_.files, &FileActions::drawingReplaced, this, &DiskWatch::follow);
  connect(&parts_.files, &FileActions::saved, this, &DiskWatch::follow);
  follow();
}

/// The document and its file are the same now.
void DiskWatch::follow() {
  if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
  path_ = parts_.document.filePath();
  known_ = path_.isEmpty() ? QByteArray() : markOf(path_);
  if (!path_.isEmpty()) watcher_.addPath(path_);
  parts_.messages.withdraw(kDiskWatchTopic);
}

QByteArray DiskWatch::markOf(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QCryptographicHash hash(QCryptographicHash::Sha1);
  hash.addData(&file);
  return hash.result();
}

void DiskWatch::look() {
  if (path_.isEmpty() || path_ != parts_.document.filePath()) return;
  watcher_.addPath(path_);  // a file that took its place is watched anew
  const QByteArray mark = markOf(path_);
  if (mark == known_) return;
  known_ = mark;
  const QString name = QFileInfo(path_).fileName();
  if (mark.isEmpty()) {
    parts_.messages.show(MessageBar::Kind::Warning,
                         tr("“%1” is gone, or cannot be read any more.").arg(name),
                         tr("What is drawn is still here; save it."), kDiskWatchTopic);
    return;
  }
  parts_.messages
      .ask(tr("Another program has changed “%1”.").arg(name),
           parts_.document.isModified() ? tr("There are unsaved changes here too.") : QString(),
           kDiskWatchTopic)
      .addAction(tr("Reload"), [this] { reload(); });
  parts_.messages.addAction(tr("Keep mine"), [this] {
    parts_.document.undoStack().resetClean();  // it is not what is saved any more
  });
}

void DiskWatch::reload() {
  if (path_ == parts_.document.filePath()) parts_.files.reload();
}

}  // namespace handmap
