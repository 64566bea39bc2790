// What the Edit and Arrange menus and the context menu of the canvas do to the drawing.
#pragma once

#include <QObject>
#include <functional>

#include "app/gui/shell/shell.h"
#include "widgets/document/map_change.h"

class QMenu;
class QSettings;

namespace handmap {

class MapCanvas;
class MapDocument;
class Toolbox;

class EditActions : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  EditActions(const Shell& shell, MapDocument& document, MapCanvas& canvas, Toolbox& tools,
              QObject* parent = nullptr);

 private:
  using Arranging = std::function<MapChange(const Map&, const QStringList&)>;

  void connectClipboard();
  void connectArranging();
  void connectSnapping();
  void arrangeBy(const char* id, Arranging arranging);
  void copy();
  void paste();
  void duplicate();
  void makeArray();
  void insert(MapChange objects, const QString& text);
  void updateEnabled();
  void showMenu(QPoint global);
  void addEnabled(QMenu& menu, std::initializer_list<const char*> ids) const;

  const Shell& shell_;
  MapDocument& document_;
  MapCanvas& canvas_;
  Toolbox& tools_;
};

}  // namespace handmap
