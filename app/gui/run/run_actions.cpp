#include "app/gui/run/run_actions.h"

#include <QMenu>
#include <QSettings>
#include <algorithm>
#include <cmath>
#include <span>

#include "app/gui/files/file_actions.h"
#include "app/gui/shell/dialogs.h"
#include "app/gui/shell/message_bar.h"
#include "core/base/error.h"
#include "core/session/redone_acts.h"
#include "widgets/actions/action_set.h"
#include "widgets/document/map_document.h"
#include "widgets/run/overlays/run_overlays.h"
#include "widgets/run/panels/buildings_panel.h"
#include "widgets/run/panels/camera_panel.h"
#include "widgets/run/panels/charts_panel.h"
#include "widgets/run/panels/layers_panel.h"
#include "widgets/run/panels/transport_bar.h"
#include "widgets/run/words/phase_words.h"
#include "widgets/run/words/words.h"

namespace handmap {

namespace {
constexpr auto kRecordingFolderKey = "files/recording_folder";
constexpr auto kAcceptTopic = "accept";
constexpr std::size_t kMostDoubtfulOffered = 3;

/// How probably the shown pose is right.
QString trustInWords(const FrameReport& report) {
  QStringList parts;
  for (std::size_t i = 0; i < kWithin_m.size(); ++i) {
    parts.push_back(handmap::RunActions::tr("%1 m: %2 %")
                        .arg(kWithin_m[i])
                        .arg(static_cast<int>(std::floor(100.0 * report.within[i]))));
  }
  return handmap::RunActions::tr("pose within %1").arg(parts.join(", "));
}
}  // namespace

RunActions::RunActions(const Parts& parts)
    : QObject(&parts.window),
      parts_(parts),
      past_({parts.run, parts.actions, parts.transport}),
      opener_(this) {
  connectActions();
  addSimulatorMenu();
  connectRun();
  connect(&parts_.files, &FileActions::drawingReplaced, this, &RunActions::onDrawingReplaced);
  connect(&parts_.document, &MapDocument::mapChanged, this, &RunActions::updateActions);
  connect(&opener_, &RecordingOpener::opened, this,
          [this](const auto& recording, const auto& acts) {
            Robot robot = recordedRobot(recording);
            robot.acts = acts;
            setRobot(std::move(robot));
            parts_.messages.show(
                MessageBar::Kind::Info,
                tr("“%1” is open: %n row(s).", nullptr, static_cast<int>(recording->rows.size()))
                    .arg(QString::fromStdString(recording->name)),
                parts_.document.map().start
                    ? tr("Press Run to localize on the drawing.")
                    : tr("Draw the buildings and where the robot starts, or open "
                         "the drawing; then press Run."));
            tellActs();
          });
  connect(&opener_, &RecordingOpener::posesOpened, this, &RunActions::usePoses);
  connect(&opener_, &RecordingOpener::simulated, this, &RunActions::setRobot);
  connect(&opener_, &RecordingOpener::failed, this, &RunActions::fail);
  updateActions();
}

void RunActions::connectActions() {
  const ActionSet& actions = parts_.actions;
  actions.on("run.open_recording", this, [this] { askForRecording(); });
  actions.on("run.load_poses", this, [this] { askForPoses(); });
  actions.on("run.run", this, [this] { runOrResume(); });
  actions.on("run.pause", this, [this] {
    past_.playback().isPlaying() ? past_.playback().pause() : parts_.run.pause();
  });
  actions.on("run.step", this, [this] {
    phases_wanted_ = false;
    if (!past_.playback().atNewest()) return past_.playback().stepOn();
    parts_.run.isActive() ? parts_.run.step() : start(RunController::Begin::WithOneStep);
  });
  actions.on("run.phase", this, [this] { nextPhase(); });
  actions.on("run.stop", this, [this] { parts_.run.stop(); });
  actions.on("run.accept", this, [this] { acceptRefinement(); });
}

void RunActions::addSimulatorMenu() {
  auto* menu = new QMenu(&parts_.window);
  menu->addAction(tr("&Two rows of buildings"), this, &RunActions::openTwoRows);
  menu->addAction(tr("A &campus"), this, [this] { openSimulation(campusSimulation(seed())); });
  menu->addAction(tr("&Around a campus"), this, [this] { openSimulation(loopSimulation(seed())); });
  menu->addAction(tr("A &quarter with fences and hedges"), this,
                  [this] { openSimulation(quarterSimulation(seed())); });
  menu->addAction(tr("T&his drawing"), this, &RunActions::simulateDrawing);
  menu->addSeparator();
  menu->addAction(tr("A &live robot (virtual rig)"), this, [this] { openVirtualRig(); });
  menu->addAction(tr("A live robot with a &stereo head"), this,
                  [this] { openVirtualRig(VirtualRigKind::StereoHead); });
  menu->addAction(tr("The &demonstration"), this, &RunActions::openDemonstration);
  parts_.actions["run.simulator"].setMenu(menu);
  parts_.actions.on("run.simulator", this, [this, menu] {  // by its key
    menu->popup(parts_.window.mapToGlobal(parts_.window.rect().center()));
  });
}

void RunActions::connectRun() {
  RunController& run = parts_.run;
  connect(&run, &RunController::stateChanged, this, [this] {
    updateActions();
    Q_EMIT stateChanged();
  });
  connect(&run, &RunController::sourceOpened, this, &RunActions::onSourceOpened);
  connect(&run, &RunController::newsArrived, this, &RunActions::onNews);
  connect(&run, &RunController::revised, this, &RunActions::onRevised);
  connect(&past_.playback(), &Playback::shown, this, &RunActions::show);
  connect(&past_.playback(), &Playback::caughtUp, this, [this] {
    if (parts_.run.state() == RunState::Paused) parts_.run.resume();
  });
  connect(&past_.playback(), &Playback::changed, this, [this] {
    updateActions();
    Q_EMIT stateChanged();
  });
  connect(&run, &RunController::progressed, &parts_.transport, &TransportBar::setShareOfStep);
  connect(&run, &RunController::frameSkipped, this, &RunActions::onFrameSkipped);
  connect(&run, &RunController::finished, this, &RunActions::onFinished);
  connect(&run, &RunController::failed, this, &RunActions::fail);
  connect(&parts_.transport, &TransportBar::speedChanged, &run, &RunController::setSpeed);
  run.setSpeed(parts_.transport.speed());
  connect(&phases_, &PhaseStepper::shown, this, [this](const Phase& phase, int number, int count) {
    parts_.transport.setPhase(phase.shown.index, phase.shown.count, PhaseWords::name(phase));
    Q_EMIT phaseShown(phase, number, count);
    updateActions();
  });
  connect(&phases_, &PhaseStepper::ended, this, &RunActions::show);
}

std::uint64_t RunActions::seed() const { return parts_.setup.setup().settings.seed; }

void RunActions::fail(const Failure& failure) {
  parts_.messages.show(MessageBar::Kind::Error, failure.message, failure.hint);
  Q_EMIT failed(failure);
}

void RunActions::setRobot(Robot robot) {
  parts_.run.discard();
  opener_.forget();
  robot_ = std::move(robot);
  source_ = nullptr;
  last_ = nullptr;
  shown_ = nullptr;
  phases_.leave();
  phases_wanted_ = false;
  parts_.overlays.clear();
  past_.begin();
  parts_.overlays.setTruth(robot_->truth);
  given_poses_.clear();
  if (robot_->truth_map) parts_.overlays.setTruthMap(*robot_->truth_map);
  parts_.layers.setAvailable(Layer::Truth, robot_->truth_map || !robot_->truth.empty());
  parts_.transport.setSource(robot_->name);
  parts_.transport.setSpeedEnabled(!robot_->live);
  updateActions();
  Q_EMIT robotChanged();
}

void RunActions::askForRecording() {
  const QString folder = parts_.dialogs.folderToOpen(
      tr("Open a recording"), parts_.settings.value(kRecordingFolderKey).toString());
  if (folder.isEmpty()) return;
  parts_.settings.setValue(kRecordingFolderKey, folder);
  openRecording(folder);
}

void RunActions::openRecording(const QString& folder) { opener_.open(folder); }

bool RunActions::openSimulation(const Demonstration& simulation) {
  if (!parts_.files.replace(simulation.sketch)) return false;
  setRobot(simulation.robot);
  return true;
}

bool RunActions::openDemonstration() {
  if (!openSimulation(demonstration())) return false;
  parts_.transport.setSpeed(kDemonstrationSpeed);
  return true;
}

bool RunActions::openVirtualRig(VirtualRigKind kind) {
  return openSimulation(liveSimulation(seed(), kind));
}

bool RunActions::openTwoRows() { return openSimulation(twoRowSimulation(seed())); }

void RunActions::simulateDrawing() {
  if (isReady(true)) opener_.simulate(parts_.document.map(), seed());
}

void RunActions::runOrResume() {
  phases_wanted_ = false;
  Playback& past = past_.playback();
  if (!past.atNewest() || (past.loop() && last_)) return past.play();
  parts_.run.isActive() ? parts_.run.resume() : start(RunController::Begin::Running);
}

void RunActions::tellActs() {
  const auto count = static_cast<int>(robot_->acts.size());
  if (count == 0) return;
  parts_.messages
      .show(MessageBar::Kind::Info,
            tr("On that drive somebody said %n thing(s): where the robot was, or which building "
               "is right or not there. The run does it again.",
               nullptr, count))
      .addAction(tr("Leave it out"), [this, acts = robot_->acts] {
        if (robot_ && robot_->acts == acts) robot_->acts.clear();
      });
}

/// The drawing is changed as it was then, which can be undone.
RunSetup RunActions::redoActs() {
  RunSetup setup = parts_.setup.setup();
  setup.settings.given_poses = given_poses_;
  if (robot_->acts.empty()) return setup;
  const RedoneActs done = redone(parts_.document.map(), robot_->acts);
  MapChange changed;
  QStringList gone;
  for (const Building& building : parts_.document.map().buildings) {
    const Building* now = done.drawing.find(building.id);
    if (now == nullptr) gone << QString::fromStdString(building.id);
    if (now != nullptr && !(*now == building)) changed.buildings.push_back(*now);
  }
  if (!changed.isEmpty()) parts_.document.apply(changed, tr("Buildings that are right"));
  if (!gone.isEmpty()) parts_.document.remove(gone);
  if (setup.settings.given_poses.empty()) setup.settings.given_poses = done.poses;
  return setup;
}

void RunActions::askForPoses() {
  const QString file =
      parts_.dialogs.fileToOpen({tr("Open poses of the robot"),
                                 parts_.settings.value(kRecordingFolderKey).toString(),
                                 tr("Poses in TUM form (*.tum *.txt)"),
                                 {},
                                 {}});
  if (!file.isEmpty()) opener_.openPoses(file);
}

/// The run that there is, is done again with them; else the next one goes through them.
void RunActions::usePoses(const std::vector<StampedPose>& poses) {
  given_poses_ = poses;
  if (parts_.run.canRevise()) return Q_EMIT posesGiven(poses);
  parts_.messages
      .show(MessageBar::Kind::Info, tr("The next run goes through %n given pose(s).", nullptr,
                                       static_cast<int>(poses.size())))
      .addAction(tr("Forget them"), [this] { given_poses_.clear(); });
}

void RunActions::start(RunController::Begin begin) {
  if (!robot_ || !isReady(false)) return;
  last_ = nullptr;
  shown_ = nullptr;
  phases_.leave();
  phases_wanted_ = begin == RunController::Begin::WithPhases;
  skipped_ = 0;
  finished_ = false;
  parts_.messages.clear();
  parts_.charts.clear();
  parts_.camera.setSnapshot(nullptr);
  const RunSetup setup = redoActs();
  parts_.charts.showSampleSize(setup.settings.method == Method::Paper);
  parts_.buildings.model().setDrawing(parts_.document.map());
  parts_.run.start(parts_.document.map(), *robot_, setup, begin);
  past_.begin();
}

void RunActions::onSourceOpened(std::shared_ptr<const SourceInfo> source) {
  source_ = std::move(source);
  parts_.overlays.setTruth(source_->truth);
  parts_.layers.setAvailable(Layer::Truth, robot_->truth_map || !source_->truth.empty());
  Q_EMIT runBegan(source_->camera.has_value());
}

void RunActions::onNews(const RunNews& news) {
  last_ = news.newest;
  parts_.charts.add(news.reports);
  past_.onNews(news.reports, last_->index, last_->count);
  if (past_.playback().atNewest()) return show(last_);
  updateActions();
  Q_EMIT stateChanged();
}

/// The next of the observation that is gone through; else of the next observation.
void RunActions::nextPhase() {
  if (phases_.isActive()) return phases_.next();
  phases_wanted_ = true;
  if (!past_.playback().atNewest()) {
    past_.playback().stepOn();
    phases_wanted_ = false;  // few moments of the past have theirs
    return;
  }
  parts_.run.isActive() ? parts_.run.stepPhases() : start(RunController::Begin::WithPhases);
}

void RunActions::show(const std::shared_ptr<const Snapshot>& snapshot) {
  shown_ = snapshot;
  phases_.leave();
  if (phases_wanted_ && snapshot->phases) {
    phases_wanted_ = false;
    parts_.camera.setSnapshot(snapshot);
    return phases_.begin(snapshot);
  }
  parts_.camera.setSnapshot(snapshot);
  parts_.overlays.show(*snapshot);
  parts_.buildings.model().setRefined(*snapshot->map);
  parts_.transport.setShown(snapshot->index, snapshot->count, snapshot->report);
  updateActions();
  Q_EMIT stateChanged();
}

/// All of it is another run's now.
void RunActions::onRevised() {
  parts_.charts.clear();
  parts_.buildings.model().setDrawing(parts_.run.drawing());
  past_.begin();
  past_.showGiven(parts_.run.settings().given_poses);
}

void RunActions::onFrameSkipped(int frame, const QString& reason) {
  ++skipped_;
  const QString what =
      skipped_ == 1
          ? tr("Frame %1 was skipped: %2").arg(frame).arg(reason)
          : tr("%1 frames were skipped; the latest, %2: %3").arg(skipped_).arg(frame).arg(reason);
  parts_.messages.show(MessageBar::Kind::Warning, what, {}, QStringLiteral("skipped"));
  past_.onSkipped(frame, reason);
}

void RunActions::onFinished(bool cancelled) {
  finished_ = !cancelled;
  if (phases_.isActive() && last_) show(last_);
  updateActions();
  Q_EMIT stateChanged();
  if (cancelled || warnOfResult() || skipped_ > 0) return;
  const auto result = score();
  if (!result) return;
  const Map& drawing = parts_.run.drawing();
  const MapChanges changes = changesOf(drawing, parts_.run.result()->map());
  parts_.messages.show(MessageBar::Kind::Info,
                       tr("The run is done. %1").arg(Words::changes(changes, drawing)),
                       scoreInWords(*result));
  const std::size_t offered = std::min(changes.doubtful.size(), kMostDoubtfulOffered);
  for (const BuildingChange& change : std::span(changes.doubtful).first(offered)) {
    const QString id = QString::fromStdString(drawing.buildings[change.building].id);
    parts_.messages.addAction(id, [this, id] { Q_EMIT parts_.buildings.showRequested(id); });
  }
  parts_.messages.addAction(tr("Accept refinement"), [this, run = parts_.run.number()] {
    if (run == parts_.run.number()) acceptRefinement();
  });
}

bool RunActions::warnOfResult() {
  const auto result = parts_.run.result();
  if (!result) return false;
  for (const RunWarning& warning : result->warnings) {
    parts_.messages.show(MessageBar::Kind::Warning, QString::fromStdString(warning.message),
                         QString::fromStdString(warning.hint));
    offer("draw.start", tr("Place the start"));
  }
  return !result->warnings.empty();
}

void RunActions::offer(const QString& action, const QString& text) {
  parts_.messages.addAction(text, [this, action] { parts_.actions[action].trigger(); });
}

bool RunActions::isReady(bool may_start_on_route) {
  const Map& drawing = parts_.document.map();
  if (drawing.buildings.empty()) {
    fail({ErrorCode::BadInput, tr("There are no buildings yet to find the robot among."),
          tr("Draw at least one that the robot comes by.")});
    offer("draw.rectangle", tr("Draw"));
    return false;
  }
  if (!drawing.start && !(may_start_on_route && !drawing.route.empty())) {
    fail({ErrorCode::BadInput, tr("The map has no start."),
          tr("Press where the robot begins, drag to where it looks, release.")});
    offer("draw.start", tr("Place the start"));
    return false;
  }
  return true;
}

std::optional<RunScore> RunActions::score() const {
  const auto result = parts_.run.result();
  if (!result || !last_ || !source_ || !robot_) return std::nullopt;
  return scoreRun(parts_.run.drawing(), result->map(), robot_->truth_map, *last_, source_->truth);
}

void RunActions::acceptRefinement() {
  const auto result = parts_.run.result();
  if (!result) return;
  const QStringList edited = parts_.document.editedSince(parts_.run.drawing());
  if (edited.isEmpty()) return parts_.document.acceptRefinement(result->map());
  Message& question =
      parts_.messages.ask(tr("%n building(s) were edited since the run began: %1", nullptr,
                             static_cast<int>(edited.size()))
                              .arg(edited.mid(0, 8).join(QStringLiteral(", "))),
                          tr("Their corrected shapes are of the drawing before."), kAcceptTopic);
  question.addAction(tr("Take all others"), [this, result, edited] {
    parts_.document.acceptRefinement(result->map(), edited);
  });
  question.addAction(tr("Take all"),
                     [this, result] { parts_.document.acceptRefinement(result->map()); });
}

void RunActions::onDrawingReplaced() {
  parts_.run.discard();
  opener_.forgetSimulation();
  source_ = nullptr;
  last_ = nullptr;
  shown_ = nullptr;
  phases_.leave();
  phases_wanted_ = false;
  parts_.overlays.clear();
  past_.begin();
  parts_.messages.clear();
  parts_.messages.withdraw(kAcceptTopic);
  if (robot_ && robot_->truth_map) robot_.reset();  // it lived in the drawing before
  parts_.transport.setSource(robot_ ? robot_->name : QString());
  parts_.overlays.setTruth(robot_ ? robot_->truth : std::vector<StampedPose>());
  updateActions();
  Q_EMIT stateChanged();
  Q_EMIT runForgotten();
}

void RunActions::updateActions() {
  const RunState state = parts_.run.state();
  const bool can_start = robot_ && state == RunState::Idle;
  const bool can_go_on = state == RunState::Paused;
  const bool has_result = parts_.run.result() != nullptr;
  const Playback& past = past_.playback();
  const bool can_play = !past.atNewest() && !past.isPlaying();
  const QString why_not =
      robot_ ? tr("a run is under way") : tr("no recording, robot or simulator is open");
  parts_.actions.setEnabled({"run.run"}, can_start || can_go_on || can_play, why_not);
  parts_.actions.setEnabled({"run.step"}, can_start || can_go_on || !past.atNewest(), why_not);
  parts_.actions.setEnabled({"run.load_poses"}, robot_ && !robot_->live,
                            tr("no recording or simulator is open"));
  parts_.actions.setEnabled(
      {"run.phase"}, can_start || can_go_on || !past.atNewest() || phases_.isActive(), why_not);
  parts_.actions.setEnabled({"run.pause"}, state == RunState::Running || past.isPlaying(),
                            tr("nothing is running"));
  // The drive of a live robot is ended first, and then, if need be, the run that smooths it.
  const bool can_stop = state == RunState::Running || state == RunState::Paused ||
                        (state == RunState::Stopping && parts_.run.live());
  parts_.actions.setEnabled({"run.stop"}, can_stop, tr("nothing is running"));
  parts_.actions.setEnabled({"run.accept", "file.export_map", "file.export_trajectory"}, has_result,
                            tr("no run has corrected anything yet"));
}

QString RunActions::stateInWords() const {
  QString where;
  if (shown_) {
    where = shown_->count > 0 ? tr(", %1 of %2").arg(shown_->index).arg(shown_->count)
                              : tr(", %1").arg(shown_->index);
    where += QStringLiteral("; ") + trustInWords(shown_->report);
  }
  if (shown_ && !past_.playback().atNewest()) return tr("Looking back") + where;
  switch (parts_.run.state()) {
    case RunState::Running:
      if (last_) return tr("Running") + where;
      return robot_->opening.isEmpty() ? tr("Opening") : robot_->opening;
    case RunState::Paused:
      return tr("Paused") + where;
    case RunState::Stopping:
      return parts_.run.live() ? tr("Finishing") : tr("Stopping");
    case RunState::Idle:
      break;
  }
  const bool done = last_ && (last_->count > 0 ? last_->index == last_->count : finished_);
  if (last_) return (done ? tr("Done") : tr("Stopped")) + where;
  return robot_ ? tr("Ready to run") : tr("No robot");
}

}  // namespace handmap
