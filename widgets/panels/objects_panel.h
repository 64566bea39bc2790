// The tree of everything drawn. A click selects, a double click or Enter asks to be shown, F2
// renames, the space bar shows, hides and locks.
#pragma once

#include <QSet>
#include <QWidget>

#include "widgets/document/map_document.h"

class QTreeView;
class QSortFilterProxyModel;

namespace handmap {

class ObjectTreeModel;

class ObjectsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ObjectsPanel(MapDocument& document, QWidget* parent = nullptr);

 Q_SIGNALS:
  void showRequested(const QString& key);  ///< for MapCanvas::zoomToObject

 private:
  void selectFromTree();
  void follow(const Touched& touched);
  void expandNodes();
  void showSelection();

  MapDocument& document_;
  ObjectTreeModel* model_;
  QSortFilterProxyModel* filter_;
  QTreeView* tree_;
  QSet<int> collapsed_;  ///< nodes that somebody has closed
  bool syncing_ = false;
};

}  // namespace handmap
