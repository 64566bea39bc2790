// All tools of the canvas, and the commands of the window that one of them carries out.
#pragma once

#include <QObject>

#include "widgets/canvas/map_canvas.h"

namespace handmap {

class FreehandTool;
class GeoPinTool;
class PaperTool;
class PictureTool;
class SelectTool;

class Toolbox : public QObject {
  Q_OBJECT
 public:
  /// Gives the canvas its tools. Both must outlive this object.
  Toolbox(MapDocument& document, MapCanvas& canvas, QObject* parent = nullptr);

  PictureTool& pictureTool() { return *picture_; }
  GeoPinTool& geoPinTool() { return *geo_pin_; }
  PaperTool& paperTool() { return *paper_; }
  /// Whether the freehand tool guesses what a stroke was meant to be.
  void setRecognizing(bool on);
  bool canAddCorner() const;
  /// To what is selected: where the context menu was opened, or behind the chosen corner.
  void addCorner();

 Q_SIGNALS:
  /// Somebody says that the robot is there, at the moment that is shown.
  void robotPoseGiven(const handmap::Pose2& pose);

 private:
  template <typename ToolType, typename... Arguments>
  ToolType* add(Arguments&&... arguments);

  MapDocument& document_;
  MapCanvas& canvas_;
  SelectTool* select_;
  FreehandTool* freehand_;
  PictureTool* picture_;
  GeoPinTool* geo_pin_;
  PaperTool* paper_;
};

}  // namespace handmap
