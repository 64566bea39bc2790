// The inspector at the right of the window: docks, one tabbed over another, that open and fold
// together. What is in them is the rooms' own; here is when they are shown, and where.
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

  /// In the order of the menu; Floating: a window of its own over the drawing.
  enum class Group { Drawing, Run, Floating };
  enum class When {
    Always,    ///< as the person leaves it
    Asked,     ///< not before somebody asks for it
    Run,       ///< while a run exists, unless somebody has closed it
    RunAsked,  ///< the same, and not before somebody asks for it
    Camera,    ///< while a run with a camera exists
    Now,       ///< while there is something to show: setPossible()
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
  /// Comes in front when it becomes possible, unless somebody has closed it.
  void setPossible(const QWidget& panel, bool possible);
  /// That of a panel, in front; not while it has no run to show.
  void show(const QWidget& panel);
  /// The same, and the inspector stays folded where somebody has folded it.
  void bringForward(const QWidget& panel);
  void addSwitches(QMenu& menu) const;
  /// As they are at the first start in a window of that size: folded where there is little room.
  void arrange(QSize window);
  bool isOpen() const { return open_; }
  void setOpen(bool open);
  /// Pixels, with its tabs; 0 while it is folded.
  int width() const;
  /// After the window has been given the state of an earlier session. The width is told apart: the
  /// state's is that of a window of another size.
  void restored(bool open, int width);

 Q_SIGNALS:
  void opened(bool open);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Dock {
    Spec spec;
    QDockWidget* widget;
    bool possible = true;  ///< there is something to show
  };
  static bool isDocked(const Dock& dock);
  void setWidth(int width);
  void showAll();
  const Dock* dockOf(const QWidget& panel) const;

  QMainWindow& window_;
  std::vector<Dock> docks_;
  QSet<QDockWidget*> closed_;     ///< by the user, or never asked for
  QDockWidget* front_ = nullptr;  ///< of those that are folded away
  bool open_ = true;
  bool arranging_ = false;
};

}  // namespace handmap
