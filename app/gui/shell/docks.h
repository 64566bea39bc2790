// The docks of the window. What is in them is the rooms' own; here is when they are shown, where,
// and how large.
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <QSet>
#include <vector>

class QMenu;

namespace handmap {

class Docks : public QObject {
  Q_OBJECT
 public:
  explicit Docks(QMainWindow& window);

  /// One tabbed over another; Floating: a window of its own over the drawing.
  enum class Group { Drawing, Details, Run, Floating };
  enum class When {
    Always,    ///< as the person leaves it
    Asked,     ///< not before somebody asks for it
    Run,       ///< while a run exists, unless somebody has closed it
    RunAsked,  ///< the same, and not before somebody asks for it
    Camera,    ///< while a run with a camera exists
    Robot,     ///< while there is a live robot
  };
  struct Spec {
    QString name;  ///< for the state of the window
    QString title;
    Group group;
    When when;
    bool in_front = false;  ///< of those that it is tabbed with, at the first start
    bool in_menu = true;
    QSize size = {};  ///< of a floating one, at first
  };
  /// In the order of the tabs. The panel may be taller than its dock where it is scrolled().
  QDockWidget& add(const Spec& spec, QWidget* panel);
  static QWidget* scrolled(QWidget* panel);

  /// Those of a run come and go with it; what the user has closed stays closed.
  void showRunDocks(bool run_exists, bool has_camera);
  /// That of the devices, while there is a live robot.
  void showRobotDock(bool is_live);
  /// That of a panel, in front; not while it has no run to show.
  void show(const QWidget& panel);
  void addSwitches(QMenu& menu) const;
  /// As they are at the first start in a window of that size: side by side, or one over another
  /// where there is little room.
  void arrange(QSize window);

 private:
  struct Dock {
    Spec spec;
    QDockWidget* widget;
  };
  void tabify(QDockWidget& dock, Group group);
  void setShown(const Dock& dock, bool wanted);
  void resize();

  QMainWindow& window_;
  std::vector<Dock> docks_;
  QSet<QDockWidget*> closed_by_user_;
  bool robot_shown_ = false;
  bool compact_ = false;
};

}  // namespace handmap
