// Exact numbers of what is selected; of the whole map when nothing is. Every change is one undoable
// step, a row of keystrokes in one field too.
#pragma once

#include <QWidget>

#include "widgets/document/map_document.h"

class QStackedWidget;

namespace handmap {

class PicturePage;
class PictureTool;
class PropertyPage;

class PropertyPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PropertyPanel(MapDocument& document, QWidget* parent = nullptr);

  /// What lays pictures under the drawing.
  void setPictureTool(PictureTool& tool);

 Q_SIGNALS:
  void messageRaised(const QString& message);  ///< why a change was refused
  void pictureToolRequested();

 private:
  PropertyPage* pageOfSelection() const;
  void refresh();

  MapDocument& document_;
  QStackedWidget* pages_;
  PropertyPage* building_;
  PropertyPage* landmark_;
  PropertyPage* start_;
  PicturePage* picture_;
  PropertyPage* map_;
  PropertyPage* summary_;
};

}  // namespace handmap
