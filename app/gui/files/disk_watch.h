// Notices when another program changes the file of the drawing, and asks whose work shall stay.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace handmap {

class FileActions;
class MapDocument;
class MessageBar;

class DiskWatch : public QObject {
  Q_OBJECT
 public:
  /// All of it must outlive this object.
  struct Parts {
    MapDocument& document;
    FileActions& files;
    MessageBar& messages;
  };
  DiskWatch(const Parts& parts, QObject* parent);

 private:
  void follow();
  void look();
  void reload();
  /// A short mark of what the file holds; empty: it cannot be read.
  static QByteArray markOf(const QString& path);

  Parts parts_;
  QFileSystemWatcher watcher_;
  QTimer timer_;
  QString path_;
  QByteArray known_;
};

}  // namespace handmap
