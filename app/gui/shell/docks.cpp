#include "app/gui/shell/docks.h"

#include <QDockWidget>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QTimer>
#include <QUndoView>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/rig/live_panel.h"
#include "widgets/actions/keys_panel.h"
#include "widgets/document/map_document.h"
#include "widgets/panels/drawing_layers_panel.h"
#include "widgets/panels/issues_panel.h"
#include "widgets/panels/objects_panel.h"
#include "widgets/panels/property_panel.h"
#include "widgets/run/panels/buildings_panel.h"
#include "widgets/run/panels/camera_panel.h"
#include "widgets/run/panels/charts_panel.h"
#include "widgets/run/panels/layers_panel.h"
#include "widgets/run/panels/log_panel.h"
#include "widgets/run/panels/run_setup_panel.h"
#include "widgets/run/panels/why_panel.h"
#include "widgets/teach/teach_panel.h"

namespace handmap {

namespace {

constexpr QSize kRoomyWindow(1000, 700);
constexpr QSize kKeysSize(640, 520);
constexpr QPoint kFloatingAt(160, 240);  // below the messages; where nobody has moved them

/// A panel that may be taller than its dock.
QScrollArea* scrolled(QWidget* panel) {
  auto* area = new QScrollArea;
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidgetResizable(true);
  area->setWidget(panel);
  return area;
}

/// One below the other.
QWidget* stacked(std::initializer_list<QWidget*> panels) {
  auto* stack = new QWidget;
  auto* layout = new QVBoxLayout(stack);
  layout->setContentsMargins({});
  layout->setSpacing(0);
  for (QWidget* panel : panels) layout->addWidget(panel);
  layout->addStretch();
  return stack;
}

/// Every step since the drawing was opened; a click goes back or forth to it.
QWidget* historyOf(MapDocument& document) {
  auto* view = new QUndoView(&document.undoStack());
  view->setAccessibleName(Docks::tr("Steps of editing"));
  view->setEmptyLabel(Docks::tr("As it was opened"));
  view->setFrameShape(QFrame::NoFrame);
  return view;
}

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

}  // namespace

Docks::Docks(QMainWindow& window, MapDocument& document)
    : QObject(&window),
      window_(window),
      objects_(new ObjectsPanel(document)),
      properties_(new PropertyPanel(document)),
      layers_(new LayersPanel),
      issues_(new IssuesPanel(document)),
      setup_(new RunSetupPanel),
      charts_(new ChartsPanel),
      camera_(new CameraPanel),
      buildings_(new BuildingsPanel),
      log_(new LogPanel),
      why_(new WhyPanel),
      teach_(new TeachPanel),
      live_(new LivePanel),
      objects_dock_(add("objects", tr("Objects"), objects_)),
      properties_dock_(add("properties", tr("Properties"), properties_)),
      layers_dock_(add("layers", tr("Layers"),
                       scrolled(stacked({new DrawingLayersPanel(document), layers_})))),
      issues_dock_(add("issues", tr("Issues"), issues_)),
      history_dock_(add("history", tr("History"), historyOf(document))),
      setup_dock_(add("setup", tr("Run settings"), scrolled(setup_))),
      charts_dock_(add("charts", tr("Charts"), charts_)),
      camera_dock_(add("camera", tr("Camera"), camera_)),
      buildings_dock_(add("buildings", tr("Buildings"), buildings_)),
      log_dock_(add("log", tr("Log"), log_)),
      why_dock_(add("why", tr("Why"), why_)),
      teach_dock_(add("teach", tr("Teach buildings"), scrolled(teach_))),
      live_dock_(add("live", tr("Robot"), live_)),
      keys_dock_(add("keys", tr("Keyboard shortcuts"), nullptr)) {
  window_.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks |
                         QMainWindow::AllowNestedDocks);
  window_.tabifyDockWidget(objects_dock_, layers_dock_);
  window_.tabifyDockWidget(properties_dock_, issues_dock_);
  window_.tabifyDockWidget(issues_dock_, history_dock_);
  window_.tabifyDockWidget(history_dock_, setup_dock_);
  window_.tabifyDockWidget(charts_dock_, camera_dock_);
  window_.tabifyDockWidget(camera_dock_, buildings_dock_);
  window_.tabifyDockWidget(buildings_dock_, log_dock_);
  window_.tabifyDockWidget(log_dock_, why_dock_);
  window_.tabifyDockWidget(why_dock_, live_dock_);
  layers_dock_->raise();
  properties_dock_->raise();
  setup_dock_->hide();
  history_dock_->hide();
  for (const auto& [dock, size] :
       {std::pair(teach_dock_, teach_->sizeHint()), std::pair(keys_dock_, kKeysSize)}) {
    dock->hide();
    dock->setFloating(true);
    dock->resize(size);
    dock->move(kFloatingAt);
  }
  closed_by_user_.insert(why_dock_);  // until it is asked for
  connect(why_dock_, &QDockWidget::visibilityChanged, this, &Docks::whyShown);
  for (QDockWidget* dock :
       {charts_dock_, camera_dock_, buildings_dock_, log_dock_, why_dock_, live_dock_}) {
    connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool shown) {
      if (shown) {
        closed_by_user_.remove(dock);
      } else {
        closed_by_user_.insert(dock);
      }
    });
  }
  showRunDocks(false, false);
  showLiveDock(false);
  connect(issues_, &IssuesPanel::found, this, [this] {
    const auto count = issues_->issues().size();
    issues_dock_->setWindowTitle(count == 0 ? tr("Issues") : tr("Issues (%1)").arg(count));
  });
}

QDockWidget* Docks::add(const QString& name, const QString& title, QWidget* panel) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(name);
  if (panel) dock->setWidget(panel);
  window_.addDockWidget(Qt::RightDockWidgetArea, dock);
  connect(dock, &QDockWidget::visibilityChanged, this, [dock](bool visible) {
    if (visible && dock->isFloating()) keepOnScreen(*dock);
  });
  return dock;
}

void Docks::showRunDocks(bool run_exists, bool has_camera) {
  const auto show = [this](QDockWidget* dock, bool wanted) {
    dock->toggleViewAction()->setEnabled(wanted);
    dock->setVisible(wanted && !closed_by_user_.contains(dock));
  };
  show(charts_dock_, run_exists);
  show(buildings_dock_, run_exists);
  show(log_dock_, run_exists);
  show(why_dock_, run_exists);
  show(camera_dock_, run_exists && has_camera);
  if (!run_exists) return;
  const bool is_live = live_dock_->isVisible();
  (has_camera ? camera_dock_ : is_live ? live_dock_ : charts_dock_)->raise();
  QTimer::singleShot(0, this, &Docks::resize);  // when they have been laid out
}

void Docks::showLiveDock(bool is_live) {
  live_dock_->toggleViewAction()->setEnabled(is_live);
  live_dock_->setVisible(is_live && !closed_by_user_.contains(live_dock_));
  const bool appears = is_live && !live_shown_;
  live_shown_ = is_live;
  if (!appears) return;
  live_dock_->raise();
  QTimer::singleShot(0, this, &Docks::resize);
}

void Docks::showProperties() {
  properties_dock_->show();
  properties_dock_->raise();
}

void Docks::showSetup() {
  setup_dock_->show();
  setup_dock_->raise();
}

void Docks::showTeach() {
  teach_dock_->show();
  teach_dock_->raise();
}

void Docks::showWhy() {
  if (!why_dock_->toggleViewAction()->isEnabled()) return;
  closed_by_user_.remove(why_dock_);
  why_dock_->show();
  why_dock_->raise();
  QTimer::singleShot(0, this, &Docks::resize);
}

bool Docks::isWhyShown() const { return why_->isVisible(); }

void Docks::setKeys(KeysPanel* keys) { keys_dock_->setWidget(keys); }

void Docks::showKeys() {
  keys_dock_->show();
  keys_dock_->raise();
}

void Docks::addSwitches(QMenu& menu) const {
  for (const QDockWidget* dock : {objects_dock_, layers_dock_, properties_dock_, issues_dock_,
                                  history_dock_, setup_dock_, charts_dock_, camera_dock_,
                                  buildings_dock_, log_dock_, why_dock_, live_dock_, teach_dock_}) {
    menu.addAction(dock->toggleViewAction());
  }
}

void Docks::arrange(QSize window) {
  compact_ = window.width() < kRoomyWindow.width() || window.height() < kRoomyWindow.height();
  if (compact_) {
    window_.tabifyDockWidget(layers_dock_, properties_dock_);
    window_.tabifyDockWidget(properties_dock_, issues_dock_);
    window_.tabifyDockWidget(issues_dock_, history_dock_);
    window_.tabifyDockWidget(history_dock_, setup_dock_);
    layers_dock_->raise();
  }
  resize();
}

void Docks::resize() {
  const int width = compact_ ? 220 : 300;
  QList<QDockWidget*> docks;
  QList<int> heights;
  const auto add = [&](QDockWidget* dock, int height) {
    if (dock->isHidden() || dock->isFloating()) return;
    docks << dock;
    heights << height;
  };
  for (QDockWidget* dock : {objects_dock_, layers_dock_}) add(dock, compact_ ? 200 : 250);
  for (QDockWidget* dock : {properties_dock_, issues_dock_, setup_dock_})
    add(dock, compact_ ? 200 : 150);
  for (QDockWidget* dock :
       {charts_dock_, camera_dock_, buildings_dock_, log_dock_, why_dock_, live_dock_}) {
    add(dock, compact_ ? 240 : 290);
  }
  window_.resizeDocks(docks, QList<int>(docks.size(), width), Qt::Horizontal);
  window_.resizeDocks(docks, heights, Qt::Vertical);
}

}  // namespace handmap
