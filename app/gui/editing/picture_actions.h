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

class PictureActions : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  PictureActions(const Shell& shell, MapDocument& document, MapCanvas& canvas, PictureTool& tool,
                 PropertyPanel& properties, ReferenceTrust& trust, QObject* parent);

  /// Lays it where its file tells, else about `middle` (metres; absent: the middle of the canvas),
  /// as large as it shows whole. What goes wrong is told in the message bar.
  void add(const QString& path, std::optional<QPointF> middle = {});

 private:
  void ask();
  void adjust(int mode);

  const Shell& shell_;
  MapDocument& document_;
  MapCanvas& canvas_;
  PictureTool& tool_;
  PropertyPanel& properties_;
  ReferenceTrust& trust_;
};

}  // namespace handmap
