#include "app/gui/shell/docks.h"

#include <QChildEvent>
#include <QGuiApplication>
#include <QMenu>
#include <QScopedValueRollback>
#include <QScreen>
#include <QScrollArea>
#include <QTabBar>
#include <algorithm>

namespace handmap {

namespace {

constexpr QSize kRoomyWindow(1000, 700);  // pixels; a smaller one is the drawing's
constexpr int kFirstWidth = 300;          // pixels
constexpr QPoint kFloatingAt(160, 240);   // below the messages; where nobody has moved them

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
  // Beside the panels: however many there are, no title is cut.
  window_.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::East);
  window_.installEventFilter(this);
}

bool Docks::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ChildPolished) {
    auto* tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child());
    if (tabs != nullptr) tabs->setElideMode(Qt::ElideNone);
  }
  return QObject::eventFilter(watched, event);
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
  if (spec.group == Group::Floating) {
    dock->setFloating(true);
    dock->resize(spec.size);
    dock->move(kFloatingAt);
  } else {
    const auto last = std::find_if(docks_.rbegin(), docks_.rend(), [](const Dock& other) {
      return other.spec.group != Group::Floating;
    });
    if (last != docks_.rend()) window_.tabifyDockWidget(last->widget, dock);
  }
  connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool shown) {
    if (!shown) {
      closed_.insert(dock);
      return;
    }
    closed_.remove(dock);
    if (!dock->isFloating()) setOpen(true);
    dock->raise();
  });
  connect(dock->toggleViewAction(), &QAction::toggled, this, [this, dock](bool shown) {
    // By its cross: neither here nor with the window.
    if (!shown && !arranging_ && window_.isVisible() && dock->isHidden()) closed_.insert(dock);
  });
  if (spec.when == When::Asked || spec.when == When::RunAsked) closed_.insert(dock);
  docks_.push_back({spec, dock, spec.when == When::Always || spec.when == When::Asked});
  showAll();
  for (const Dock& other : docks_) {
    if (!other.spec.in_front) continue;
    front_ = other.widget;
    front_->raise();
  }
  return *dock;
}

bool Docks::isDocked(const Dock& dock) {
  return dock.spec.group != Group::Floating && !dock.widget->isFloating();
}

/// What is possible, wanted and not folded away.
void Docks::showAll() {
  const QScopedValueRollback arranging(arranging_, true);
  for (const Dock& dock : docks_) {
    const bool shown =
        dock.possible && !closed_.contains(dock.widget) && (open_ || !isDocked(dock));
    dock.widget->toggleViewAction()->setEnabled(dock.possible);
    if (dock.widget->isHidden() == shown) dock.widget->setVisible(shown);
  }
}

void Docks::setOpen(bool open) {
  if (open == open_) return;
  for (const Dock& dock : docks_)
    if (isDocked(dock) && !dock.widget->visibleRegion().isEmpty()) front_ = dock.widget;
  open_ = open;
  showAll();
  if (open && front_ != nullptr) front_->raise();
  Q_EMIT opened(open_);
}

int Docks::width() const {
  for (const Dock& dock : docks_) {
    if (!isDocked(dock) || dock.widget->visibleRegion().isEmpty()) continue;
    return window_.dockWidgetArea(dock.widget) == Qt::RightDockWidgetArea
               ? window_.width() - dock.widget->x()
               : dock.widget->width();
  }
  return 0;
}

void Docks::setWidth(int width) {
  const auto docked = std::ranges::find_if(docks_, &Docks::isDocked);
  if (docked != docks_.end()) window_.resizeDocks({docked->widget}, {width}, Qt::Horizontal);
}

void Docks::restored(bool open, int width) {
  for (const Dock& dock : docks_) {
    const bool is_ours = dock.spec.when == When::Always || dock.spec.when == When::Asked;
    // In a folded inspector all are hidden, which says nothing of each.
    if (!is_ours || (!open && isDocked(dock))) continue;
    closed_.remove(dock.widget);
    if (dock.widget->isHidden()) closed_.insert(dock.widget);
  }
  open_ = open;
  showAll();
  setWidth(width > 0 ? width : kFirstWidth);
  // What was in front may have been of a run that is no more.
  for (const Dock& dock : docks_)
    if (dock.spec.in_front) dock.widget->raise();
  Q_EMIT opened(open_);
}

void Docks::showRunDocks(bool run_exists, bool has_camera) {
  for (Dock& dock : docks_) {
    if (!isOfRun(dock.spec.when)) continue;
    dock.possible = run_exists && (has_camera || dock.spec.when != When::Camera);
  }
  showAll();
}

void Docks::setPossible(const QWidget& panel, bool possible) {
  for (Dock& dock : docks_) {
    if (!dock.widget->isAncestorOf(&panel) || dock.possible == possible) continue;
    dock.possible = possible;
    showAll();
    if (possible && !dock.widget->isHidden()) dock.widget->raise();
  }
}

const Docks::Dock* Docks::dockOf(const QWidget& panel) const {
  const auto found = std::ranges::find_if(
      docks_, [&panel](const Dock& dock) { return dock.widget->isAncestorOf(&panel); });
  return found == docks_.end() || !found->possible ? nullptr : &*found;
}

void Docks::show(const QWidget& panel) {
  const Dock* dock = dockOf(panel);
  if (dock == nullptr) return;
  closed_.remove(dock->widget);
  if (isDocked(*dock)) setOpen(true);
  showAll();
  dock->widget->raise();
}

void Docks::bringForward(const QWidget& panel) {
  const Dock* dock = dockOf(panel);
  if (dock != nullptr && !dock->widget->isHidden()) dock->widget->raise();
}

void Docks::addSwitches(QMenu& menu) const {
  for (const Group group : {Group::Drawing, Group::Run, Group::Floating}) {
    for (const Dock& dock : docks_) {
      if (dock.spec.group == group && dock.spec.in_menu)
        menu.addAction(dock.widget->toggleViewAction());
    }
  }
}

void Docks::arrange(QSize window) {
  setWidth(kFirstWidth);
  setOpen(window.width() >= kRoomyWindow.width() && window.height() >= kRoomyWindow.height());
}

}  // namespace handmap
