#include "app/gui/window/main_window.h"

#include <QCloseEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/editing/edit_actions.h"
#include "app/gui/editing/georeference_actions.h"
#include "app/gui/editing/paper_actions.h"
#include "app/gui/editing/picture_actions.h"
#include "app/gui/files/disk_watch.h"
#include "app/gui/files/file_actions.h"
#include "app/gui/files/map_model.h"
#include "app/gui/files/recovery_offer.h"
#include "app/gui/files/reference_trust.h"
#include "app/gui/files/template_menu.h"
#include "app/gui/rig/rig_actions.h"
#include "app/gui/run/compare_actions.h"
#include "app/gui/run/drawing_watch.h"
#include "app/gui/run/live_watch.h"
#include "app/gui/run/result_actions.h"
#include "app/gui/run/revision_actions.h"
#include "app/gui/run/run_exports.h"
#include "app/gui/run/run_views.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/run/transport_actions.h"
#include "app/gui/shell/docks.h"
#include "app/gui/shell/welcome_strip.h"
#include "app/gui/window/comfort.h"
#include "app/gui/window/file_kinds.h"
#include "app/gui/window/welcome.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/messages/message_bar.h"
#include "widgets/panels/issues_panel.h"
#include "widgets/panels/objects_panel.h"
#include "widgets/panels/property_panel.h"
#include "widgets/run/overlays/run_overlays.h"
#include "widgets/run/panels/layers_panel.h"
#include "widgets/run/panels/log_panel.h"
#include "widgets/run/panels/run_setup_panel.h"
#include "widgets/run/panels/transport_bar.h"
#include "widgets/style/elided_label.h"
#include "widgets/style/names.h"
#include "widgets/teach/teach_panel.h"
#include "widgets/tools/toolbox.h"

namespace handmap {

namespace {

constexpr auto kNotNowTopic = "not now";
constexpr auto kGeometryKey = "window/geometry";
constexpr auto kStateKey = "window/state";
constexpr auto kInspectorKey = "window/inspector";
constexpr auto kInspectorWidthKey = "window/inspector_width";
constexpr int kStateVersion = 8;  // of the set of docks and bars
constexpr QSize kFirstSize(1280, 900);

}  // namespace

MainWindow::MainWindow(MapDocument& document, QSettings& settings, std::unique_ptr<Dialogs> dialogs)
    : document_(document),
      settings_(settings),
      dialogs_(dialogs ? std::move(dialogs) : systemDialogs(*this)),
      canvas_(new MapCanvas(document_)),
      tools_(new Toolbox(document_, *canvas_, this)),
      messages_(new MessageBar(canvas_)),
      welcome_(new WelcomeStrip),
      centre_(makeCentre()),
      transport_(new TransportBar),
      teach_(new TeachPanel),
      run_panels_(RunPanels::make()),
      editing_panels_(EditingPanels::make(document_, &run_panels_.layers, docks_)),
      shell_{*this, actions_, *messages_, *dialogs_, docks_, settings_},
      hint_(new ElidedLabel),
      cursor_(new QLabel),
      scale_(new QLabel),
      run_state_(new QLabel) {
  run_panels_.addTo(docks_);
  docks_.add({"teach", tr("Teach buildings"), Docks::Group::Floating, Docks::When::Asked, false,
              true, teach_->sizeHint()},
             Docks::scrolled(teach_));
  files_ = new FileActions(shell_, document_, *canvas_);
  files_->setLegend([this] { return run_panels_.layers.legend(); });
  new GeoreferenceActions(shell_, document_, tools_->geoPinTool(), this);
  makeRun();
  auto* trust = new ReferenceTrust(shell_, document_, *files_, this);
  pictures_ = new PictureActions(shell_, document_, *canvas_, tools_->pictureTool(),
                                 editing_panels_.properties, *trust, this);
  new PaperActions(shell_, document_, *canvas_, tools_->paperTool(), *files_, *trust, this);
  model_ = new MapModel(shell_, document_, *files_, *teach_, this);
  connect(trust, &ReferenceTrust::granted, model_, &MapModel::loadOfDrawing);
  templates_ = new TemplateMenu(shell_, document_, *files_, this);
  new DiskWatch(shell_, document_, *files_, this);
  connectRecovery();
  makeBars();
  makeStatusBar();
  connectEditing();
  connectTools();
  connectView();
  new Welcome(shell_, *welcome_,
              {document_, *canvas_, *files_, *sources_, *runs_, *rigs_, *comfort_}, this);
  files_->setOthers(QStringLiteral(";;") + SourceActions::logFilter(), [this](const QString& path) {
    return openOther(path, canvas_->viewport()->rect().center());
  });
  setAcceptDrops(true);
  nameInputs(*this);
  restoreState();
  updateTitle();
}

/// From the source of a run to what it comes to: each hears of the run after those before it.
void MainWindow::makeRun() {
  overlays_ = std::make_unique<RunOverlays>(*canvas_->scene(), kOverlayZ);
  overlays_->setColours(Colours::of(palette()));
  run_.setPrepare(overlays_->preparation());
  sources_ = new SourceActions(shell_, document_, *files_, run_, run_panels_.setup);
  views_ =
      new RunViews(shell_, *canvas_, document_, *files_, *sources_, run_, *overlays_, run_panels_);
  runs_ = new TransportActions(shell_, document_, *files_, *sources_, run_, *views_, *transport_);
  results_ = new ResultActions(shell_, document_, *files_, *sources_, run_, run_panels_.buildings);
  auto* exports = new RunExports(shell_, document_, *files_, *sources_, run_);
  exports->setActs([this] { return revisions_->acts(); });
  new CompareActions(shell_, document_, *canvas_, *files_, *sources_, run_, this);
  rigs_ = new RigActions(shell_, run_, *sources_, *files_, this);
  live_watch_ = new LiveWatch(shell_, run_, *sources_, this);
  new DrawingWatch(shell_, document_, run_, *sources_, this);
  revisions_ = std::make_unique<RevisionActions>(shell_, document_, run_, *canvas_, *tools_,
                                                 runs_->past(), run_panels_.said);
  connect(sources_, &SourceActions::posesGiven, this,
          [this](const std::vector<StampedPose>& poses) { revisions_->takePoses(poses); });
}

MainWindow::~MainWindow() {
  hide();  // docks tell of it, while whoever hears of that is there
  run_.discard();
  delete views_;  // it hears of panels that go, when the overlays it works with have gone
}

QWidget* MainWindow::makeCentre() {
  // Files that are dropped are the window's business, not the scene's.
  canvas_->setAcceptDrops(false);
  canvas_->viewport()->setAcceptDrops(false);
  auto* centre = new QWidget;
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(welcome_);
  layout->addWidget(canvas_, 1);
  setCentralWidget(centre);
  return centre;
}

void MainWindow::makeBars() {
  actions_.fillMenuBar(*menuBar());
  auto* main_bar = addToolBar(tr("Main"));
  main_bar->setObjectName("main_bar");
  actions_.fillToolBar(*main_bar, ToolBar::Main);
  auto* tool_bar = new QToolBar(tr("Tools"));
  tool_bar->setObjectName("tool_bar");
  addToolBar(Qt::LeftToolBarArea, tool_bar);
  actions_.fillToolBar(*tool_bar, ToolBar::Tools);
  addToolBar(Qt::BottomToolBarArea, makeTransport());
  comfort_ = new Comfort(shell_, *files_,
                         {*tool_bar, *canvas_, editing_panels_.issues, *transport_}, this);
  Comfort::tidy(*menuBar(), actions_);

  for (QAction* top : menuBar()->actions()) {
    QMenu* menu = top->menu();
    if (menu->actions().contains(&actions_["file.save"])) {
      menu->insertMenu(&actions_["file.open"], &templates_->menu());
      menu->insertMenu(&actions_["file.save"], &files_->recentMenu());
    }
    if (menu->actions().contains(&actions_["view.grid"])) {
      menu->addSeparator();
      docks_.addSwitches(*menu);
    }
  }
}

/// Over the whole width of the window: what a run is doing is never hidden for want of room.
QToolBar* MainWindow::makeTransport() {
  QToolBar& buttons = transport_->toolBar();
  actions_.fillToolBar(buttons, ToolBar::Transport);
  // What is next has its words beside it; on a small screen there is no room for those of others.
  const auto tell_next = [this, &buttons] {
    const bool has_robot = sources_->robot().has_value();
    for (const auto& [id, next] :
         {std::pair("run.simulate", !has_robot), std::pair("run.run", has_robot),
          std::pair("run.accept", actions_["run.accept"].isEnabled())}) {
      auto* button = qobject_cast<QToolButton*>(buttons.widgetForAction(&actions_[id]));
      if (button != nullptr)
        button->setToolButtonStyle(next ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    }
  };
  connect(sources_, &SourceActions::robotChanged, this, tell_next);
  connect(&actions_["run.accept"], &QAction::enabledChanged, this, tell_next);
  tell_next();
  auto* bar = new QToolBar(tr("Transport"));
  bar->setObjectName("transport_bar");
  bar->setMovable(false);
  bar->toggleViewAction()->setVisible(false);
  bar->addWidget(transport_);
  return bar;
}

void MainWindow::makeStatusBar() {
  cursor_->setMinimumWidth(fontMetrics().horizontalAdvance("-0000.00, -0000.00 m"));
  scale_->setMinimumWidth(fontMetrics().horizontalAdvance("0.00123 px/m"));
  scale_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  cursor_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  statusBar()->addWidget(hint_, 1);
  statusBar()->addPermanentWidget(cursor_);
  statusBar()->addPermanentWidget(scale_);
  statusBar()->addPermanentWidget(run_state_);
  run_state_->setMinimumWidth(fontMetrics().horizontalAdvance(tr("Running, 000 of 000")));
  run_state_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // never widens the window
  const auto show_hint = [this](const QString& hint) {
    hint_->setText(hint);
    hint_->setToolTip(hint);
  };
  show_hint(canvas_->hint());
  connect(canvas_, &MapCanvas::hintChanged, this, show_hint);
  connect(canvas_, &MapCanvas::cursorMoved, this, [this](QPointF metres) {
    cursor_->setText(tr("x %1 m, y %2 m").arg(metres.x(), 0, 'f', 2).arg(metres.y(), 0, 'f', 2));
  });
  const auto show_scale = [this](double pixels_per_metre) {
    scale_->setText(tr("%1 px/m").arg(pixels_per_metre, 0, 'g', 3));
  };
  show_scale(canvas_->pixelsPerMetre());
  connect(canvas_, &MapCanvas::scaleChanged, this, show_scale);
  const auto show_run = [this] { run_state_->setText(runs_->stateInWords()); };
  show_run();
  connect(runs_, &TransportActions::stateChanged, this, show_run);
  connect(sources_, &SourceActions::robotChanged, this, show_run);
}

void MainWindow::connectEditing() {
  new EditActions(shell_, document_, *canvas_, *tools_, this);
  actions_.on("edit.settings", this, [this] { docks_.show(run_panels_.setup); });
  actions_.on("run.teach", this, [this] { docks_.show(*teach_); });
  connect(teach_, &TeachPanel::classifierChanged, &run_panels_.setup,
          &RunSetupPanel::setTaughtClassifier);
  connect(teach_, &TeachPanel::messageRaised, this,
          [this](const QString& message) { messages_->show(MessageBar::Kind::Warning, message); });
  actions_.on("file.keep_template", this, [this] { templates_->keep(); });
  actions_.on("file.quit", this, [this] { close(); });
  actions_.on("help.about", this, [this] {
    messages_->show(MessageBar::Kind::Info, tr("Handmap %1").arg(HANDMAP_VERSION),
                    tr("Draw the map you remember; Handmap finds the robot on it and corrects the "
                       "drawing. Free software: GPL-3.0-or-later, without any warranty."));
  });
  connect(&document_, &MapDocument::fileChanged, this, &MainWindow::updateTitle);
  connect(&editing_panels_.properties, &PropertyPanel::messageRaised, this,
          [this](const QString& message) { messages_->show(MessageBar::Kind::Warning, message); });
}

void MainWindow::connectTools() {
  static constexpr std::pair<const char*, ToolId> kTools[] = {
      {"draw.select", ToolId::Select},
      {"draw.rectangle", ToolId::Rectangle},
      {"draw.edge_rectangle", ToolId::EdgeRectangle},
      {"draw.polygon", ToolId::Corners},
      {"draw.freehand", ToolId::Freehand},
      {"draw.start", ToolId::Start},
      {"draw.route", ToolId::Route},
      {"draw.landmark", ToolId::Landmark},
      {"draw.measure", ToolId::Measure},
      {"draw.eraser", ToolId::Eraser},
      {"run.give_pose", ToolId::RobotPose},
      {"draw.georeference", ToolId::GeoPin},
      {"draw.picture", ToolId::Picture}};
  for (const auto& [id, tool] : kTools) {
    actions_[id].setChecked(tool == canvas_->tool());
    actions_.on(id, canvas_, [this, tool = tool] {
      canvas_->setTool(tool);
      canvas_->setFocus(Qt::OtherFocusReason);  // whatever had it: what is typed next is the tool's
    });
  }
  connect(canvas_, &MapCanvas::toolChanged, this, [this](ToolId tool) {
    for (const auto& [id, its_tool] : kTools) {
      if (its_tool == tool) actions_[id].setChecked(true);
    }
  });
}

void MainWindow::connectView() {
  actions_.on("view.zoom_in", canvas_, [this] { canvas_->zoomIn(); });
  actions_.on("view.zoom_out", canvas_, [this] { canvas_->zoomOut(); });
  actions_.on("view.zoom_fit", canvas_, [this] { canvas_->zoomToFit(); });
  actions_["view.grid"].setChecked(canvas_->isGridVisible());
  actions_.on("view.grid", this, [this](bool on) { run_panels_.layers.setOn(Layer::Grid, on); });
  actions_["view.uncertainty"].setChecked(true);
  actions_.on("view.uncertainty", canvas_, [this](bool on) { canvas_->setDoubtVisible(on); });
  connect(&run_panels_.layers, &LayersPanel::toggled, this, &MainWindow::setLayer);
  connect(&run_panels_.layers, &LayersPanel::opacityChanged, this,
          [this](Layer layer, double share) {
            if (layer == Layer::Drawing) return canvas_->setDrawingOpacity(share);
            overlays_->setLayerOpacity(layer, share);
          });
  run_panels_.layers.setAvailable(Layer::Truth, false);
  run_panels_.layers.setRun(false, false);

  connect(&editing_panels_.objects, &ObjectsPanel::showRequested, canvas_,
          &MapCanvas::zoomToObject);
  connect(&editing_panels_.issues, &IssuesPanel::showRequested, this, &MainWindow::showIssue);
  connect(files_, &FileActions::drawingReplaced, canvas_, &MapCanvas::zoomToFit);
  connect(files_, &FileActions::georeferenceWanted, this, [this] {
    document_.setSelection({});  // the page of the map itself
    docks_.show(editing_panels_.properties);
  });
  connect(files_, &FileActions::drawingReplaced, canvas_,
          [this] { canvas_->setFocus(Qt::OtherFocusReason); });
  actions_.on("view.inspector", this, [this](bool open) { docks_.setOpen(open); });
  connect(&docks_, &Docks::opened, &actions_["view.inspector"], &QAction::setChecked);
}

void MainWindow::connectRecovery() {
  recovery_ = new Recovery(document_, *teach_, settings_, {}, this);
  recovery_offer_ = new RecoveryOffer(
      *this, *messages_, *recovery_, [this] { return files_->mayLeave(); }, this);
  connect(recovery_offer_, &RecoveryOffer::recovered, this, [this](bool with_teaching) {
    Q_EMIT files_->drawingReplaced();
    if (with_teaching) docks_.show(*teach_);
  });
  connect(recovery_, &Recovery::cannotKeep, this,
          [this](const QString& reason, const QString& instead) {
            if (instead.isEmpty()) {
              messages_
                  ->show(MessageBar::Kind::Warning,
                         tr("Unsaved work would be lost in a crash: %1").arg(reason))
                  .addAction(tr("Save"), [this] { files_->save(); });
            } else {
              messages_->show(MessageBar::Kind::Info, tr("Unsaved work is kept in %1").arg(instead),
                              reason);
            }
          });
}

void MainWindow::offerRecovery() {
  recovery_offer_->look();
  live_watch_->offerCutOff();
}

void MainWindow::showIssue(const Issue& issue) {
  constexpr double kAround = 15.0;  // metres
  if (issue.kind == Issue::Kind::NoBuilding) return actions_["draw.rectangle"].trigger();
  if (issue.kind == Issue::Kind::NoStart) return actions_["draw.start"].trigger();
  QStringList keys;
  for (const std::string& id : issue.ids) keys << QString::fromStdString(id);
  if (issue.kind == Issue::Kind::RouteFarFromStart) keys << kRouteKey;
  document_.setSelection(keys);
  if (issue.at) {
    const QPointF reach(kAround, kAround);
    const QPointF at(issue.at->x(), issue.at->y());
    canvas_->zoomToRect(QRectF(at - reach, at + reach));
  }
}

void MainWindow::setLayer(Layer layer, bool on) {
  switch (layer) {
    case Layer::Drawing:
      return canvas_->setDrawingVisible(on);
    case Layer::Underlays:
      return canvas_->setUnderlaysVisible(on);
    case Layer::Grid:
      actions_["view.grid"].setChecked(on);
      return canvas_->setGridVisible(on);
    default:
      return overlays_->setLayerVisible(layer, on);
  }
}

void MainWindow::updateTitle() {
  setWindowTitle(document_.displayName() + QStringLiteral("[*] — Handmap"));
  setWindowModified(document_.isModified());
}

void MainWindow::restoreState() {
  // The screen with room for the frame around the window.
  const QSize room = screen()->availableSize() - QSize(20, 60);
  resize(kFirstSize.boundedTo(room));
  if (room.width() < kFirstSize.width() || room.height() < kFirstSize.height()) {
    setWindowState(Qt::WindowMaximized);
  }
  restoreGeometry(settings_.value(kGeometryKey).toByteArray());
  if (QMainWindow::restoreState(settings_.value(kStateKey).toByteArray(), kStateVersion)) {
    docks_.restored(settings_.value(kInspectorKey, true).toBool(),
                    settings_.value(kInspectorWidthKey).toInt());
  } else {
    docks_.arrange(screen()->availableSize().boundedTo(kFirstSize));
  }
  docks_.showRunDocks(false, false);
  run_panels_.setup.restore(settings_);
  run_panels_.layers.restore(settings_);
}

void MainWindow::saveState() {
  settings_.setValue(kGeometryKey, saveGeometry());
  settings_.setValue(kStateKey, QMainWindow::saveState(kStateVersion));
  settings_.setValue(kInspectorKey, docks_.isOpen());
  if (const int width = docks_.width(); width > 0) settings_.setValue(kInspectorWidthKey, width);
  run_panels_.setup.save(settings_);
  run_panels_.layers.save(settings_);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->mayLeave() || !model_->mayClose() || !files_->mayClose()) {
    event->ignore();
    return;
  }
  run_.discard();
  recovery_->clear();
  saveState();
  event->accept();
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && overlays_) {
    overlays_->setColours(Colours::of(palette()));
  }
  QMainWindow::changeEvent(event);
}

/// Only keys of commands that are disabled come here: the others were taken as shortcuts.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  const QString id = actions_.ownerOf({QKeySequence(event->keyCombination())}, {});
  const QString why_not = id.isEmpty() ? QString() : actions_.whyNot(id);
  if (why_not.isEmpty()) return QMainWindow::keyPressEvent(event);
  const QString command = actions_[id].iconText();
  messages_->show(MessageBar::Kind::Info, tr("“%1” is not possible now: %2.").arg(command, why_not),
                  {}, kNotNowTopic);
  if (id != QLatin1String("run.run") || run_.state() != RunState::Idle) return;
  const char* simulator = document_.map().buildings.empty() ? "run.simulator" : "run.simulate";
  for (const char* source : {simulator, "run.open_recording", "run.connect"}) {
    messages_->addAction(actions_[source].text(), [this, source] { actions_[source].trigger(); });
  }
}

/// Through what can be seen and be used: not into panels that others cover, nor ways in that a
/// click takes.
bool MainWindow::focusNextPrevChild(bool next) {
  constexpr int kMost = 500;  // inputs of the window, by far
  const auto is_stop = [this](const QWidget& widget) {
    // Panels that others cover lie outside.
    return rect().contains(widget.mapTo(this, widget.rect().center())) &&
           !welcome_->isAncestorOf(&widget) && !widget.inherits("QScrollArea");
  };
  for (int i = 0; i < kMost; ++i) {
    if (!QMainWindow::focusNextPrevChild(next)) return false;
    const QWidget* now = focusWidget();
    if (now == nullptr || is_stop(*now)) return true;
  }
  return false;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!draggedPath(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = draggedPath(*event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  const QPoint on_canvas = canvas_->viewport()->mapFrom(this, event->position().toPoint());
  if (!openOther(path, on_canvas)) files_->open(path);
}

bool MainWindow::openOther(const QString& path, const QPoint& on_canvas) {
  switch (fileKindOf(path)) {
    case FileKind::Drawing:
    case FileKind::Unknown:
      return false;
    case FileKind::Recording:
      sources_->openRecording(path);
      break;
    case FileKind::Log:
      sources_->importLog(path);
      break;
    case FileKind::Rig:
      rigs_->openRig(path);
      break;
    case FileKind::Picture:
      pictures_->add(path, canvas_->mapToScene(on_canvas));
      break;
  }
  return true;
}

}  // namespace handmap
