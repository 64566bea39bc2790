#include "app/gui/run/transport_actions.h"

#include "app/gui/files/file_actions.h"
#include "app/gui/run/live_robot.h"
#include "app/gui/run/run_views.h"
#include "app/gui/run/source_actions.h"
#include "widgets/actions/action_set.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/message_bar.h"
#include "widgets/run/panels/timeline.h"
#include "widgets/run/panels/transport_bar.h"
#include "widgets/run/words/phase_words.h"
#include "widgets/run/words/words.h"

namespace handmap {

namespace {

constexpr auto kTrimTopic = "trim";
constexpr int kLook_ms = 250;

/// What a robot that has not observed anything is at; empty where it says nothing.
QString doingInWords(const RigStatus& status) {
  for (const DeviceStatus& device : status.devices) {
    const bool is_missed =
        device.state == DeviceState::Connecting || device.state == DeviceState::Lost;
    if (device.role <= DeviceRole::Head && is_missed && !device.detail.empty())
      return QString::fromStdString(device.detail);
  }
  return QString::fromStdString(status.activity);
}

}  // namespace

TransportActions::TransportActions(const Shell& shell, MapDocument& document, FileActions& files,
                                   SourceActions& sources, RunController& run, RunViews& views,
                                   TransportBar& transport)
    : QObject(&shell.window),
      shell_(shell),
      document_(document),
      sources_(sources),
      run_(run),
      views_(views),
      transport_(transport),
      past_(shell, run, transport),
      drive_start_(shell, document) {
  connectActions();
  connectRun();
  connect(&sources_, &SourceActions::robotChanged, this, &TransportActions::forget);
  connect(&files, &FileActions::drawingReplaced, this, [this] {
    forget();
    Q_EMIT stateChanged();
  });
  connect(&sources_, &SourceActions::speedWanted, &transport_, &TransportBar::setSpeed);
  connect(&views_, &RunViews::timeChosen, &past_, &PlaybackActions::seekTime);
  connect(this, &TransportActions::phaseShown, &views_, &RunViews::showPhase);
  connect(&sources_, &SourceActions::trimChanged, this,
          [this] { transport_.timeline().setTrim(sources_.trim()); });
  connect(&transport_.timeline(), &Timeline::trimWanted, &sources_, &SourceActions::setTrim);
  files.setComingBack([this] { return comingBack(); });
  connect(&past_, &PlaybackActions::noted, &views_, &RunViews::note);
  update();
}

void TransportActions::connectActions() {
  const ActionSet& actions = shell_.actions;
  actions.on("run.run", this, [this] { runOrResume(); });
  actions.on("run.pause", this,
             [this] { past_.playback().isPlaying() ? past_.playback().pause() : run_.pause(); });
  actions.on("run.step", this, [this] {
    phases_wanted_ = false;
    if (!past_.playback().atNewest()) return past_.playback().stepOn();
    run_.isActive() ? run_.step() : start(RunController::Begin::WithOneStep);
  });
  actions.on("run.phase", this, [this] { nextPhase(); });
  actions.on("run.stop", this, [this] { run_.stop(); });
}

void TransportActions::connectRun() {
  const auto changed = [this] {
    update();
    Q_EMIT stateChanged();
  };
  // What it waits for changes without a word of the run.
  waiting_.setInterval(kLook_ms);
  connect(&waiting_, &QTimer::timeout, this, &TransportActions::stateChanged);
  connect(this, &TransportActions::stateChanged, this, [this] {
    const bool waits = run_.state() == RunState::Running && !last_ && run_.live();
    if (waits != waiting_.isActive()) waits ? waiting_.start() : waiting_.stop();
  });
  connect(&run_, &RunController::stateChanged, this, changed);
  connect(&run_, &RunController::newsArrived, this, &TransportActions::onNews);
  connect(&run_, &RunController::revised, this, &TransportActions::onRevised);
  connect(&run_, &RunController::progressed, &transport_, &TransportBar::setShareOfStep);
  connect(&run_, &RunController::frameSkipped, &past_, &PlaybackActions::onSkipped);
  connect(&run_, &RunController::finished, this, &TransportActions::onFinished);
  connect(&past_.playback(), &Playback::shown, this, &TransportActions::show);
  connect(&past_.playback(), &Playback::caughtUp, this, [this] {
    if (run_.state() == RunState::Paused) run_.resume();
  });
  connect(&past_.playback(), &Playback::changed, this, changed);
  connect(&transport_, &TransportBar::speedChanged, &run_, &RunController::setSpeed);
  run_.setSpeed(transport_.speed());
  connect(&phases_, &PhaseStepper::shown, this, [this](const Phase& phase, int number, int count) {
    transport_.setPhase(phase.shown.index, phase.shown.count, PhaseWords::name(phase));
    Q_EMIT phaseShown(phase, number, count);
    update();
  });
  connect(&phases_, &PhaseStepper::ended, this, &TransportActions::show);
}

void TransportActions::forget() {
  last_ = nullptr;
  shown_ = nullptr;
  phases_.leave();
  phases_wanted_ = false;
  past_.begin();
  const auto& robot = sources_.robot();
  transport_.setSource(robot ? robot->name : QString());
  transport_.setSpeedEnabled(!robot || !robot->live);
  update();
}

void TransportActions::runOrResume() {
  phases_wanted_ = false;
  Playback& past = past_.playback();
  if (!past.atNewest() || (past.loop() && last_)) return past.play();
  run_.isActive() ? run_.resume() : start(RunController::Begin::Running);
}

void TransportActions::start(RunController::Begin begin) {
  if (!sources_.robot() || !sources_.isReady()) return;
  if (drive_start_.ask(*sources_.robot(), [this, begin] { start(begin); })) return;
  last_ = nullptr;
  shown_ = nullptr;
  phases_.leave();
  phases_wanted_ = begin == RunController::Begin::WithPhases;
  finished_ = false;
  shell_.messages.clear();
  RunSetup setup = sources_.nextSetup();
  setup.settings.seen_at_start = drive_start_.takeSeen();
  run_.start(document_.map(), *sources_.robot(), setup, begin);
  past_.begin();
  transport_.timeline().beginTrimmed();
  tellTrim();
}

/// Somebody has asked for a part, perhaps long ago.
void TransportActions::tellTrim() {
  const auto trim = sources_.trim();
  if (!trim || trim->from == trim->first) return;
  shell_.messages.show(
      MessageBar::Kind::Info,
      tr("The run begins with frame %1 of the recording, as you have chosen.").arg(trim->from),
      tr("The robot is taken to be at the start of the drawing then."), kTrimTopic);
}

/// The recording, and the run of it where there was one.
QStringList TransportActions::comingBack() const {
  const auto& robot = sources_.robot();
  if (!robot || robot->folder.isEmpty()) return {};
  QStringList arguments{QStringLiteral("--recording"), robot->folder};
  if (run_.result()) {
    arguments << QStringLiteral("--run") << QStringLiteral("--fast") << QStringLiteral("--seed")
              << QString::number(run_.settings().seed);
  }
  return arguments;
}

void TransportActions::onNews(const RunNews& news) {
  last_ = news.newest;
  past_.onNews(news.reports, last_->index, last_->count);
  if (past_.playback().atNewest()) return show(last_);
  update();
  Q_EMIT stateChanged();
}

/// The next of the observation that is gone through; else of the next observation.
void TransportActions::nextPhase() {
  if (phases_.isActive()) return phases_.next();
  phases_wanted_ = true;
  if (!past_.playback().atNewest()) {
    past_.playback().stepOn();
    phases_wanted_ = false;  // few moments of the past have theirs
    return;
  }
  run_.isActive() ? run_.stepPhases() : start(RunController::Begin::WithPhases);
}

void TransportActions::show(const std::shared_ptr<const Snapshot>& snapshot) {
  shown_ = snapshot;
  phases_.leave();
  views_.showPicture(snapshot);
  if (phases_wanted_ && snapshot->phases) {
    phases_wanted_ = false;
    return phases_.begin(snapshot);
  }
  views_.show(*snapshot);
  transport_.setShown(snapshot->index, snapshot->count, snapshot->report);
  update();
  Q_EMIT stateChanged();
}

/// All of it is another run's now.
void TransportActions::onRevised() {
  past_.begin();
  past_.showGiven(run_.settings().given_poses);
}

void TransportActions::onFinished(bool cancelled) {
  finished_ = !cancelled;
  if (run_.live() && last_) drive_start_.ended(run_.live(), *last_, run_.tape());
  if (phases_.isActive() && last_) show(last_);
  update();
  Q_EMIT stateChanged();
}

void TransportActions::update() {
  const RunState state = run_.state();
  const auto& robot = sources_.robot();
  const bool can_start = robot && state == RunState::Idle;
  const bool can_go_on = state == RunState::Paused;
  const Playback& past = past_.playback();
  const bool can_play = !past.atNewest() && !past.isPlaying();
  const QString why_not =
      robot ? tr("a run is under way") : tr("no recording, robot or simulator is open");
  ActionSet& actions = shell_.actions;
  actions.setEnabled({"run.run"}, can_start || can_go_on || can_play, why_not);
  actions.setEnabled({"run.step"}, can_start || can_go_on || !past.atNewest(), why_not);
  actions.setEnabled({"run.phase"},
                     can_start || can_go_on || !past.atNewest() || phases_.isActive(), why_not);
  actions.setEnabled({"run.pause"}, state == RunState::Running || past.isPlaying(),
                     tr("nothing is running"));
  // The drive of a live robot is ended first, and then, if need be, the run that smooths it.
  const bool can_stop = state == RunState::Running || state == RunState::Paused ||
                        (state == RunState::Stopping && run_.live());
  actions.setEnabled({"run.stop"}, can_stop, tr("nothing is running"));
}

/// What is shown, and how sure it is.
QString TransportActions::whereInWords() const {
  if (!shown_) return {};
  const QString where = shown_->count > 0 ? tr(", %1 of %2").arg(shown_->index).arg(shown_->count)
                                          : tr(", %1").arg(shown_->index);
  return where + QStringLiteral("; ") + Words::certainty(shown_->report);
}

QString TransportActions::openingInWords() const {
  const QString opening = sources_.robot()->opening;
  if (opening.isEmpty()) return tr("Opening");
  const auto link = run_.live();
  const auto monitor = link ? link->monitor() : nullptr;
  const QString doing = monitor ? doingInWords(monitor->status()) : QString();
  return doing.isEmpty() ? opening : tr("%1: %2").arg(opening, doing);
}

QString TransportActions::stateInWords() const {
  const QString where = whereInWords();
  const auto& robot = sources_.robot();
  if (shown_ && !past_.playback().atNewest()) return tr("Looking back") + where;
  switch (run_.state()) {
    case RunState::Running:
      if (last_) return tr("Running") + where;
      return openingInWords();
    case RunState::Paused:
      return tr("Paused") + where;
    case RunState::Stopping:
      return run_.live() ? tr("Finishing") : tr("Stopping");
    case RunState::Idle:
      break;
  }
  const bool done = last_ && (last_->count > 0 ? last_->index == last_->count : finished_);
  if (last_) return (done ? tr("Done") : tr("Stopped")) + where;
  return robot ? tr("Ready to run") : tr("No robot");
}

}  // namespace handmap
