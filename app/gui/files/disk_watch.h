// Notices when another program changes the file of the drawing, and asks whose work shall stay.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "app/gui/shell/shell.h"

namespace handmap {

class FileActions;
class MapDocument;

class DiskWatch : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  DiskWatch(const Shell& shell, MapDocument& document, FileActions& files, QObject* parent);

 private:
  void follow();
  void look();
  void reload();
  /// A short mark of what the file holds; empty: it cannot be read.
  static QByteArray markOf(const QString& path);

  const Shell& shell_;
  MapDocument& document_;
  FileActions& files_;
  QFileSystemWatcher watcher_;
  QTimer timer_;
  QString path_;
  QByteArray known_;
};

}  // namespace handmap
