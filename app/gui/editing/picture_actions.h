// Pictures under the drawing: from a file that is chosen or dropped to its place on the map.
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

class QSettings;

namespace handmap {

class ActionSet;
class Dialogs;
class Docks;
class MapCanvas;
class MapDocument;
class MessageBar;
class PictureTool;
class ReferenceTrust;

class PictureActions : public QObject {
  Q_OBJECT
 public:
  /// All of it must outlive this object.
  struct Parts {
    MapDocument& document;
    MapCanvas& canvas;
    PictureTool& tool;
    ActionSet& actions;
    Docks& docks;
    MessageBar& messages;
    ReferenceTrust& trust;
    QSettings& settings;
    Dialogs& dialogs;
  };
  PictureActions(const Parts& parts, QObject* parent);

  /// Lays it where its file tells, else about `middle` (metres; absent: the middle of the canvas),
  /// as large as it shows whole. What goes wrong is told in the message bar.
  void add(const QString& path, std::optional<QPointF> middle = {});

 private:
  void ask();
  void adjust(int mode);

  Parts parts_;
};

}  // namespace handmap
