// The list of everything drawn. A click selects, a double click asks to be shown, F2 renames.
#pragma once

#include <QWidget>

#include "widgets/document/map_document.h"

class QTreeView;
class QSortFilterProxyModel;

namespace handmap {

class ObjectListModel;

class ObjectsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ObjectsPanel(MapDocument& document, QWidget* parent = nullptr);

 Q_SIGNALS:
  void showRequested(const QString& key);  ///< for MapCanvas::zoomToObject

 private:
  void selectFromList();
  void showSelection();

  MapDocument& document_;
  ObjectListModel* model_;
  QSortFilterProxyModel* filter_;
  QTreeView* list_;
  bool syncing_ = false;
};

}  // namespace handmap
