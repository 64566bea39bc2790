// Pictures under the drawing: from a file that is chosen or dropped to its place on the map.
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "app/gui/shell/shell.h"

class QSettings;

namespace handmap {

class MapCanvas;
class MapDocument;
class PictureTool;
class PropertyPanel;
class ReferenceTrust;
class RobotMapLayer;
struct Georeference;
struct Underlay;

class PictureActions : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  PictureActions(const Shell& shell, MapDocument& document, MapCanvas& canvas, PictureTool& tool,
                 PropertyPanel& properties, ReferenceTrust& trust, QObject* parent);

  /// Lays it where its file tells, else about `middle` (metres; absent: the middle of the canvas),
  /// as large as it shows whole; a map of a robot where it is found to lie. What goes wrong is told
  /// in the message bar.
  void add(const QString& path, std::optional<QPointF> middle = {});

 private:
  static QString filter();
  void ask();
  /// The key of the picture; its path is absolute.
  QString layUnder(Underlay underlay, const std::optional<Georeference>& georeference);
  void adjust(int mode);

  const Shell& shell_;
  MapDocument& document_;
  MapCanvas& canvas_;
  PictureTool& tool_;
  PropertyPanel& properties_;
  ReferenceTrust& trust_;
  RobotMapLayer* robot_maps_;
};

}  // namespace handmap
