#include "app/gui/shell/docks.h"

#include <QGuiApplication>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QTimer>
#include <algorithm>

namespace handmap {

namespace {

constexpr QSize kRoomyWindow(1000, 700);
constexpr QPoint kFloatingAt(160, 240);  // below the messages; where nobody has moved them

/// A floating panel that is partly on no screen, or larger than it, is moved and made smaller.
void keepOnScreen(QDockWidget& dock) {
  const QRect frame = dock.frameGeometry();
  const QScreen* screen = QGuiApplication::screenAt(frame.center());
  if (screen == nullptr) screen = dock.parentWidget()->screen();
  const QRect room = screen->availableGeometry();
  if (room.contains(frame)) return;
  const QSize border = frame.size() - dock.size();
  dock.resize(dock.size().boundedTo(room.size() - border));
  const QSize size = dock.size() + border;
  dock.move(std::clamp(frame.x(), room.left(), room.right() - size.width() + 1),
            std::clamp(frame.y(), room.top(), room.bottom() - size.height() + 1));
}

bool isOfRun(Docks::When when) {
  return when == Docks::When::Run || when == Docks::When::RunAsked || when == Docks::When::Camera;
}

}  // namespace

Docks::Docks(QMainWindow& window) : QObject(&window), window_(window) {
  window_.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks |
                         QMainWindow::AllowNestedDocks);
}

QWidget* Docks::scrolled(QWidget* panel) {
  auto* area = new QScrollArea;
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidgetResizable(true);
  area->setWidget(panel);
  return area;
}

QDockWidget& Docks::add(const Spec& spec, QWidget* panel) {
  auto* dock = new QDockWidget(spec.title, &window_);
  dock->setObjectName(spec.name);
  dock->setWidget(panel);
  window_.addDockWidget(Qt::RightDockWidgetArea, dock);
  connect(dock, &QDockWidget::visibilityChanged, this, [dock](bool visible) {
    if (visible && dock->isFloating()) keepOnScreen(*dock);
  });
  tabify(*dock, spec.group);
  docks_.push_back({spec, dock});
  if (spec.when == When::Asked) dock->hide();
  if (spec.group == Group::Floating) {
    dock->setFloating(true);
    dock->resize(spec.size);
    dock->move(kFloatingAt);
  }
  if (spec.when == When::RunAsked) closed_by_user_.insert(dock);
  if (isOfRun(spec.when) || spec.when == When::Robot) {
    connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool shown) {
      if (shown) {
        closed_by_user_.remove(dock);
      } else {
        closed_by_user_.insert(dock);
      }
    });
    setShown(docks_.back(), false);
  }
  for (const Dock& other : docks_) {
    if (other.spec.group == spec.group && other.spec.in_front) other.widget->raise();
  }
  return *dock;
}

/// Over the last dock of a group.
void Docks::tabify(QDockWidget& dock, Group group) {
  if (group == Group::Floating) return;
  const auto last = std::find_if(docks_.rbegin(), docks_.rend(),
                                 [group](const Dock& other) { return other.spec.group == group; });
  if (last != docks_.rend()) window_.tabifyDockWidget(last->widget, &dock);
}

void Docks::setShown(const Dock& dock, bool wanted) {
  dock.widget->toggleViewAction()->setEnabled(wanted);
  dock.widget->setVisible(wanted && !closed_by_user_.contains(dock.widget));
}

void Docks::showRunDocks(bool run_exists, bool has_camera) {
  QDockWidget* front = nullptr;  // the camera, the robot, or the first of all
  for (const Dock& dock : docks_) {
    if (isOfRun(dock.spec.when)) {
      const bool is_camera = dock.spec.when == When::Camera;
      setShown(dock, run_exists && (has_camera || !is_camera));
      if (front == nullptr || (is_camera && has_camera)) front = dock.widget;
    } else if (dock.spec.when == When::Robot && dock.widget->isVisible() && !has_camera) {
      front = dock.widget;
    }
  }
  if (!run_exists || front == nullptr) return;
  front->raise();
  QTimer::singleShot(0, this, &Docks::resize);  // when they have been laid out
}

void Docks::showRobotDock(bool is_live) {
  const bool appears = is_live && !robot_shown_;
  robot_shown_ = is_live;
  for (const Dock& dock : docks_) {
    if (dock.spec.when != When::Robot) continue;
    setShown(dock, is_live);
    if (appears) dock.widget->raise();
  }
  if (appears) QTimer::singleShot(0, this, &Docks::resize);
}

void Docks::show(const QWidget& panel) {
  for (const Dock& dock : docks_) {
    if (!dock.widget->isAncestorOf(&panel) || !dock.widget->toggleViewAction()->isEnabled())
      continue;
    const bool appears = dock.widget->isHidden();
    closed_by_user_.remove(dock.widget);
    dock.widget->show();
    dock.widget->raise();
    if (appears && dock.spec.group == Group::Run) QTimer::singleShot(0, this, &Docks::resize);
  }
}

void Docks::addSwitches(QMenu& menu) const {
  for (const Group group : {Group::Drawing, Group::Details, Group::Run, Group::Floating}) {
    for (const Dock& dock : docks_) {
      if (dock.spec.group == group && dock.spec.in_menu)
        menu.addAction(dock.widget->toggleViewAction());
    }
  }
}

void Docks::arrange(QSize window) {
  compact_ = window.width() < kRoomyWindow.width() || window.height() < kRoomyWindow.height();
  if (compact_) {
    QDockWidget* over = nullptr;
    for (const Dock& dock : docks_) {
      if (dock.spec.group == Group::Drawing) over = dock.widget;
    }
    for (const Dock& dock : docks_) {
      if (dock.spec.group != Group::Details || over == nullptr) continue;
      window_.tabifyDockWidget(over, dock.widget);
      over = dock.widget;
    }
    for (const Dock& dock : docks_) {
      if (dock.spec.group == Group::Drawing && dock.spec.in_front) dock.widget->raise();
    }
  }
  resize();
}

void Docks::resize() {
  const int width = compact_ ? 220 : 300;
  const auto height = [this](Group group) {
    if (group == Group::Drawing) return compact_ ? 200 : 250;
    if (group == Group::Details) return compact_ ? 200 : 150;
    return compact_ ? 240 : 290;
  };
  QList<QDockWidget*> docks;
  QList<int> heights;
  for (const Dock& dock : docks_) {
    if (dock.widget->isHidden() || dock.widget->isFloating()) continue;
    docks << dock.widget;
    heights << height(dock.spec.group);
  }
  window_.resizeDocks(docks, QList<int>(docks.size(), width), Qt::Horizontal);
  window_.resizeDocks(docks, heights, Qt::Vertical);
}

}  // namespace handmap
