// The layers of the drawing and its pictures: shown or not, locked or not, how strong.
#pragma once

#include <QTreeWidget>
#include <QWidget>

#include "widgets/document/map_document.h"

class QSlider;

namespace handmap {

class DrawingLayersPanel : public QWidget {
  Q_OBJECT
 public:
  explicit DrawingLayersPanel(MapDocument& document, QWidget* parent = nullptr);

 private:
  void rebuild();
  void addRow(const QString& key, const QString& name, const LayerState& state);
  LayerState stateOfRow(const QString& key) const;
  void setState(const QString& key, const LayerState& state, const QString& text, bool mergeable);
  void take(QTreeWidgetItem* row, int column);
  void refreshSlider();
  QString chosen() const;

  MapDocument& document_;
  QTreeWidget* tree_;
  QSlider* opacity_;
  bool filling_ = false;
};

}  // namespace handmap
