// What makes the window easy to learn and to fit to one's own hand: commands, keys, light and dark,
// languages and the tour.
#pragma once

#include <QObject>

class QMenu;
class QMenuBar;
class QSettings;
class QWidget;

namespace handmap {

class ActionSet;
class CommandPalette;
class Docks;
class FileActions;
class MapCanvas;
class MessageBar;
class Tour;

class Comfort : public QObject {
  Q_OBJECT
 public:
  /// All of it must outlive this object.
  struct Parts {
    QWidget& window;
    ActionSet& actions;
    Docks& docks;
    FileActions& files;
    MapCanvas& canvas;
    QWidget& tool_bar;
    QWidget& transport;
    MessageBar& messages;
    QSettings& settings;
  };
  Comfort(const Parts& parts, QObject* parent);

  /// Puts what belongs together into menus of its own.
  static void tidy(const QMenuBar& menu_bar, const ActionSet& actions);
  void beginTour();

 private:
  Parts parts_;
  CommandPalette* palette_;
  Tour* tour_;
};

}  // namespace handmap
