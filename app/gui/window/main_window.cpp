#include "app/gui/window/main_window.h"

#include <QCloseEvent>
#include <QDir>
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
#include "app/gui/editing/picture_actions.h"
#include "app/gui/files/disk_watch.h"
#include "app/gui/files/file_actions.h"
#include "app/gui/files/map_model.h"
#include "app/gui/files/recovery_offer.h"
#include "app/gui/files/reference_trust.h"
#include "app/gui/files/template_menu.h"
#include "app/gui/rig/rig_actions.h"
#include "app/gui/run/revision_actions.h"
#include "app/gui/run/run_actions.h"
#include "app/gui/run/run_views.h"
#include "app/gui/shell/docks.h"
#include "app/gui/shell/message_bar.h"
#include "app/gui/shell/welcome_strip.h"
#include "app/gui/window/comfort.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/panels/issues_panel.h"
#include "widgets/panels/objects_panel.h"
#include "widgets/panels/property_panel.h"
#include "widgets/pictures/picture_file.h"
#include "widgets/run/overlays/run_overlays.h"
#include "widgets/run/panels/layers_panel.h"
#include "widgets/run/panels/log_panel.h"
#include "widgets/run/panels/run_setup_panel.h"
#include "widgets/run/panels/transport_bar.h"
#include "widgets/style/names.h"
#include "widgets/teach/teach_panel.h"
#include "widgets/tools/toolbox.h"

namespace handmap {

namespace {

constexpr auto kNotNowTopic = "not now";
constexpr auto kGeometryKey = "window/geometry";
constexpr auto kStateKey = "window/state";
constexpr int kStateVersion = 6;  // of the set of docks and bars
constexpr QSize kFirstSize(1280, 900);

/// The file or folder that is dragged; empty for anything else.
QString draggedPath(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  if (urls.size() != 1 || !urls.front().isLocalFile()) return {};
  const QString path = urls.front().toLocalFile();
  const bool is_known =
      path.endsWith(QLatin1String(".handmap")) || isPictureName(path) || QDir(path).exists();
  return is_known ? path : QString();
}

}  // namespace

MainWindow::MainWindow(MapDocument& document, QSettings& settings, std::unique_ptr<Dialogs> dialogs)
    : document_(document),
      settings_(settings),
      dialogs_(dialogs ? std::move(dialogs) : systemDialogs(*this)),
      canvas_(new MapCanvas(document_)),
      tools_(new Toolbox(document_, *canvas_, this)),
      messages_(new MessageBar),
      welcome_(new WelcomeStrip),
      transport_(new TransportBar),
      hint_(new QLabel),
      cursor_(new QLabel),
      scale_(new QLabel),
      run_state_(new QLabel) {
  setCentralWidget(makeCentre());
  docks_ = new Docks(*this, document_);
  overlays_ = std::make_unique<RunOverlays>(*canvas_->scene(), kOverlayZ);
  overlays_->setColours(Colours::of(palette()));
  run_.setPrepare(overlays_->preparation());
  files_ = new FileActions(
      {*this, document_, *canvas_, run_, actions_, *messages_, settings_, *dialogs_});
  runs_ = new RunActions({*this, document_, run_, *files_, actions_, *messages_, settings_,
                          *dialogs_, *overlays_, *transport_, docks_->layers(), docks_->setup(),
                          docks_->charts(), docks_->camera(), docks_->buildings()});
  views_ = new RunViews({*canvas_, document_, run_, *overlays_, *docks_, actions_}, this);
  rigs_ = new RigActions({*this, run_, *runs_, *docks_, actions_, *messages_, settings_, *dialogs_},
                         this);
  revisions_ = std::make_unique<RevisionActions>(RevisionActions::Parts{
      document_, run_, actions_, *messages_, *canvas_, *tools_, runs_->past()});
  auto* trust = new ReferenceTrust({document_, *files_, *messages_, settings_}, this);
  pictures_ = new PictureActions({document_, *canvas_, tools_->pictureTool(), actions_, *docks_,
                                  *messages_, *trust, settings_, *dialogs_},
                                 this);
  model_ = new MapModel({document_, *files_, docks_->teach(), *messages_, *dialogs_}, this);
  connect(trust, &ReferenceTrust::granted, model_, &MapModel::loadOfDrawing);
  templates_ = new TemplateMenu({*this, document_, *files_, *messages_, *dialogs_}, this);
  new DiskWatch({document_, *files_, *messages_}, this);
  connectRecovery();
  makeBars();
  makeStatusBar();
  connectEditing();
  connectView();
  connectWelcome();
  setAcceptDrops(true);
  nameInputs(*this);
  restoreState();
  updateTitle();
}

MainWindow::~MainWindow() {
  run_.discard();
  delete views_;  // it hears of docks that go, when the overlays it works with have gone
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
  layout->addWidget(messages_);
  layout->addWidget(canvas_, 1);
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
  comfort_ = new Comfort(
      {*this, actions_, *docks_, *files_, *canvas_, *tool_bar, *transport_, *messages_, settings_},
      this);
  Comfort::tidy(*menuBar(), actions_);

  for (QAction* top : menuBar()->actions()) {
    QMenu* menu = top->menu();
    if (menu->actions().contains(&actions_["file.save"])) {
      menu->insertMenu(&actions_["file.open"], &templates_->menu());
      menu->insertMenu(&actions_["file.save"], &files_->recentMenu());
    }
    if (menu->actions().contains(&actions_["view.grid"])) {
      menu->addSeparator();
      docks_->addSwitches(*menu);
    }
  }
}

/// Over the whole width of the window: what a run is doing is never hidden for want of room.
QToolBar* MainWindow::makeTransport() {
  QToolBar& buttons = transport_->toolBar();
  actions_.fillToolBar(buttons, ToolBar::Transport);
  for (const char* id : {"run.run", "run.accept"}) {
    auto* button = qobject_cast<QToolButton*>(buttons.widgetForAction(&actions_[id]));
    if (button != nullptr) button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
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
    cursor_->setText(tr("%1, %2 m").arg(metres.x(), 0, 'f', 2).arg(metres.y(), 0, 'f', 2));
  });
  const auto show_scale = [this](double pixels_per_metre) {
    scale_->setText(tr("%1 px/m").arg(pixels_per_metre, 0, 'g', 3));
  };
  show_scale(canvas_->pixelsPerMetre());
  connect(canvas_, &MapCanvas::scaleChanged, this, show_scale);
  const auto show_run = [this] { run_state_->setText(runs_->stateInWords()); };
  show_run();
  connect(runs_, &RunActions::stateChanged, this, show_run);
  connect(runs_, &RunActions::robotChanged, this, show_run);
}

void MainWindow::connectEditing() {
  edits_ = new EditActions({document_, *canvas_, *tools_, actions_, *messages_, settings_}, this);
  actions_.on("edit.settings", this, [this] { docks_->showSetup(); });
  actions_.on("run.teach", this, [this] { docks_->showTeach(); });
  connect(&docks_->teach(), &TeachPanel::classifierChanged, &docks_->setup(),
          &RunSetupPanel::setTaughtClassifier);
  connect(&docks_->teach(), &TeachPanel::messageRaised, this,
          [this](const QString& message) { messages_->show(MessageBar::Kind::Warning, message); });
  actions_.on("file.keep_template", this, [this] { templates_->keep(); });
  actions_.on("file.quit", this, [this] { close(); });
  actions_.on("help.about", this, [this] {
    messages_->show(MessageBar::Kind::Info, tr("Handmap %1").arg(HANDMAP_VERSION),
                    tr("Draw the map you remember; Handmap finds the robot on it and corrects the "
                       "drawing. Free software: GPL-3.0-or-later, without any warranty."));
  });
  connect(&document_, &MapDocument::fileChanged, this, &MainWindow::updateTitle);
  connect(&docks_->properties(), &PropertyPanel::messageRaised, this,
          [this](const QString& message) { messages_->show(MessageBar::Kind::Warning, message); });
}

void MainWindow::connectView() {
  actions_.on("view.zoom_in", canvas_, [this] { canvas_->zoomIn(); });
  actions_.on("view.zoom_out", canvas_, [this] { canvas_->zoomOut(); });
  actions_.on("view.zoom_fit", canvas_, [this] { canvas_->zoomToFit(); });
  actions_["view.grid"].setChecked(canvas_->isGridVisible());
  actions_.on("view.grid", this, [this](bool on) { docks_->layers().setOn(Layer::Grid, on); });
  actions_["view.uncertainty"].setChecked(true);
  actions_.on("view.uncertainty", canvas_, [this](bool on) { canvas_->setDoubtVisible(on); });
  connect(&docks_->layers(), &LayersPanel::toggled, this, &MainWindow::setLayer);
  connect(&docks_->layers(), &LayersPanel::opacityChanged, this, [this](Layer layer, double share) {
    if (layer == Layer::Drawing) return canvas_->setDrawingOpacity(share);
    overlays_->setLayerOpacity(layer, share);
  });
  docks_->layers().setAvailable(Layer::Truth, false);

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
      {"draw.picture", ToolId::Picture}};
  for (const auto& [id, tool] : kTools) {
    actions_[id].setChecked(tool == canvas_->tool());
    actions_.on(id, canvas_, [this, tool = tool] { canvas_->setTool(tool); });
  }
  connect(canvas_, &MapCanvas::toolChanged, this, [this](ToolId tool) {
    for (const auto& [id, its_tool] : kTools) {
      if (its_tool == tool) actions_[id].setChecked(true);
    }
  });

  connect(&docks_->objects(), &ObjectsPanel::showRequested, canvas_, &MapCanvas::zoomToObject);
  connect(&docks_->issues(), &IssuesPanel::showRequested, this, &MainWindow::showIssue);
  connect(files_, &FileActions::drawingReplaced, canvas_, &MapCanvas::zoomToFit);
  connect(files_, &FileActions::georeferenceWanted, this, [this] {
    document_.setSelection({});  // the page of the map itself
    docks_->showProperties();
  });
  connect(runs_, &RunActions::runBegan, this, [this](bool has_camera) {
    docks_->showRunDocks(true, has_camera);
    views_->begin();
  });
  connect(&runs_->past(), &PlaybackActions::noted, docks_,
          [this](double time_s, const QString& text) {
            docks_->log().model().add({time_s, LogKind::Warning, text, {}});
          });
  connect(runs_, &RunActions::posesGiven, this,
          [this](const std::vector<StampedPose>& poses) { revisions_->takePoses(poses); });
  connect(runs_, &RunActions::phaseShown, views_, &RunViews::showPhase);
  connect(views_, &RunViews::timeChosen, this,
          [this](double time_s) { runs_->past().seekTime(time_s); });
  connect(runs_, &RunActions::runForgotten, this, [this] { docks_->showRunDocks(false, false); });
}

void MainWindow::connectWelcome() {
  connect(welcome_, &WelcomeStrip::demonstrationRequested, this, [this] {
    if (runs_->openDemonstration()) runs_->runOrResume();
  });
  connect(welcome_, &WelcomeStrip::drawRequested, this, [this] {
    if (files_->replace({})) actions_["draw.rectangle"].trigger();
  });
  connect(welcome_, &WelcomeStrip::recordingRequested, runs_, &RunActions::askForRecording);
  connect(welcome_, &WelcomeStrip::simulatorRequested, runs_, &RunActions::openTwoRows);
  connect(welcome_, &WelcomeStrip::robotRequested, rigs_, &RigActions::showDialog);
  connect(welcome_, &WelcomeStrip::tourRequested, comfort_, &Comfort::beginTour);
  connect(welcome_, &WelcomeStrip::closed, this,
          [this] { settings_.setValue("welcome/closed", true); });
  welcome_->setVisible(!settings_.value("welcome/closed").toBool());
}

void MainWindow::connectRecovery() {
  recovery_ = new Recovery({document_, docks_->teach(), settings_}, {}, this);
  recovery_offer_ = new RecoveryOffer(
      {*this, *recovery_, *messages_, [this] { return files_->mayLeave(); }}, this);
  connect(recovery_offer_, &RecoveryOffer::recovered, this, [this](bool with_teaching) {
    Q_EMIT files_->drawingReplaced();
    if (with_teaching) docks_->showTeach();
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

void MainWindow::offerRecovery() { recovery_offer_->look(); }

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
  if (!QMainWindow::restoreState(settings_.value(kStateKey).toByteArray(), kStateVersion)) {
    docks_->arrange(screen()->availableSize().boundedTo(kFirstSize));
  }
  docks_->showRunDocks(false, false);
  docks_->setup().restore(settings_);
  docks_->layers().restore(settings_);
}

void MainWindow::saveState() {
  settings_.setValue(kGeometryKey, saveGeometry());
  settings_.setValue(kStateKey, QMainWindow::saveState(kStateVersion));
  docks_->setup().save(settings_);
  docks_->layers().save(settings_);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->mayLeave() || !model_->mayClose()) {
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
  for (const char* source : {"run.open_recording", "run.simulator", "run.connect"}) {
    messages_->addAction(actions_[source].text(), [this, source] { actions_[source].trigger(); });
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!draggedPath(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = draggedPath(*event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  if (QDir(path).exists()) {
    runs_->openRecording(path);
  } else if (isPictureName(path)) {
    const QPoint on_canvas = canvas_->viewport()->mapFrom(this, event->position().toPoint());
    pictures_->add(path, canvas_->mapToScene(on_canvas));
  } else {
    files_->open(path);
  }
}

}  // namespace handmap
