// What makes the window easy to learn and to fit to one's own hand: commands, keys, light and dark,
// languages and the tour.
#pragma once

#include <QObject>
#include <QPointer>

#include "app/gui/shell/shell.h"

class QMenu;
class QMenuBar;
class QWidget;

namespace handmap {

class ActionSet;
class CommandPalette;
class FileActions;
class GuideWindow;
class Tour;

class Comfort : public QObject {
  Q_OBJECT
 public:
  /// What the tour points at.
  struct Sights {
    QWidget& tool_bar;
    QWidget& canvas;
    QWidget& issues;
    QWidget& transport;
  };
  /// What it is given must outlive it.
  Comfort(const Shell& shell, FileActions& files, const Sights& sights, QObject* parent);

  /// Puts what belongs together into menus of its own.
  static void tidy(const QMenuBar& menu_bar, const ActionSet& actions);
  void beginTour();
  void openGuide();

 private:
  QWidget& window_;
  CommandPalette* palette_;
  QPointer<GuideWindow> guide_;
  Tour* tour_;
};

}  // namespace handmap
