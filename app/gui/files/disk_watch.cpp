#include "app/gui/files/disk_watch.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include "app/gui/files/file_actions.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

namespace {
constexpr int kSettledMs = 300;  // who writes a file writes it in several goes
constexpr auto kDiskWatchTopic = "changed_on_disk";
}  // namespace

DiskWatch::DiskWatch(const Shell& shell, MapDocument& document, FileActions& files, QObject* parent)
    : QObject(parent), shell_(shell), document_(document), files_(files) {
  timer_.setSingleShot(true);
  timer_.setInterval(kSettledMs);
  connect(&timer_, &QTimer::timeout, this, &DiskWatch::look);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &timer_, qOverload<>(&QTimer::start));
  connect(&files_, &FileActions::drawingReplaced, this, &DiskWatch::follow);
  connect(&files_, &FileActions::saved, this, &DiskWatch::follow);
  follow();
}

/// The document and its file are the same now.
void DiskWatch::follow() {
  if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
  path_ = document_.filePath();
  known_ = path_.isEmpty() ? QByteArray() : markOf(path_);
  if (!path_.isEmpty()) watcher_.addPath(path_);
  shell_.messages.withdraw(kDiskWatchTopic);
}

QByteArray DiskWatch::markOf(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QCryptographicHash hash(QCryptographicHash::Sha1);
  hash.addData(&file);
  return hash.result();
}

void DiskWatch::look() {
  if (path_.isEmpty() || path_ != document_.filePath()) return;
  watcher_.addPath(path_);  // a file that took its place is watched anew
  const QByteArray mark = markOf(path_);
  if (mark == known_) return;
  known_ = mark;
  const QString name = QFileInfo(path_).fileName();
  if (mark.isEmpty()) {
    shell_.messages.show(MessageBar::Kind::Warning,
                         tr("“%1” is gone, or cannot be read any more.").arg(name),
                         tr("What is drawn is still here; save it."), kDiskWatchTopic);
    return;
  }
  shell_.messages
      .ask(tr("Another program has changed “%1”.").arg(name),
           document_.isModified() ? tr("There are unsaved changes here too.") : QString(),
           kDiskWatchTopic)
      .addAction(tr("Reload"), [this] { reload(); });
  shell_.messages.addAction(tr("Keep mine"), [this] {
    document_.undoStack().resetClean();  // it is not what is saved any more
  });
}

void DiskWatch::reload() {
  if (path_ == document_.filePath()) files_.reload();
}

}  // namespace handmap
