#include "app/gui/run/revision_actions.h"

#include <QGraphicsScene>
#include <algorithm>

#include "app/gui/run/live_robot.h"
#include "app/gui/run/playback_actions.h"
#include "app/gui/run/run_controller.h"
#include "app/gui/shell/docks.h"
#include "core/map/places.h"
#include "core/session/redone_acts.h"
#include "widgets/actions/action_set.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/message_bar.h"
#include "widgets/run/overlays/path_item.h"
#include "widgets/run/panels/said_panel.h"
#include "widgets/tools/toolbox.h"

namespace handmap {

namespace {

constexpr auto kRevisionActionsTopic = "revision";
constexpr double kMoved_m = 0.1;

}  // namespace

QString differenceInWords(const Snapshot& before, const Snapshot& after) {
  double farthest = 0.0;
  int moved = 0;
  const auto places = placesOf(before.map->buildings);
  for (const Building& building : after.map->buildings) {
    const auto old = places.find(building.id);
    if (old == places.end()) continue;
    const double distance =
        (building.box().centre - before.map->buildings[old->second].box().centre).norm();
    farthest = std::max(farthest, distance);
    if (distance > kMoved_m) ++moved;
  }
  const double pose = (after.report.pose.position() - before.report.pose.position()).norm();
  const QString robot = RevisionActions::tr("the robot moves by %1 m").arg(pose, 0, 'f', 2);
  if (moved == 0) return RevisionActions::tr("No building moves; %1.").arg(robot);
  return RevisionActions::tr("%n building(s) move by up to %1 m; %2.", nullptr, moved)
      .arg(farthest, 0, 'f', 1)
      .arg(robot);
}

RevisionActions::RevisionActions(const Shell& shell, MapDocument& document, RunController& run,
                                 MapCanvas& canvas, Toolbox& tools, PlaybackActions& past,
                                 SaidPanel& panel)
    : shell_(shell),
      document_(document),
      run_(run),
      canvas_(canvas),
      tools_(tools),
      past_(past),
      panel_(panel),
      acts_(document),
      outcome_(std::make_unique<PathItem>(Role::Preview)) {
  outcome_->setZValue(kOverlayZ + 50.0);
  canvas_.scene()->addItem(outcome_.get());
  const ActionSet& actions = shell_.actions;
  actions.on("run.recompute", this, [this] {
    revise(acts_.poses(), Then::Ask, tr("Recomputing with the drawing as it is"));
  });
  actions.on("run.right", this, [this] { setRight(); });
  actions.on("run.not_there", this, [this] { removeNotThere(); });
  actions.on("run.forget_poses", this, [this] {
    say({{{shownTime(), Act::Kind::ForgetPoses, {}, {}, {}}}}, tr("Forget given poses"),
        tr("Recomputing without the poses that were given"));
  });
  connectSaid();
  connect(&tools_, &Toolbox::robotPoseGiven, this, [this](const Pose2& pose) {
    if (run_.history() && !run_.history()->empty()) give(shownTime(), pose);
  });
  connect(&run_, &RunController::poseGiven, this, &RevisionActions::give);
  connect(&recorder_, &ActRecorder::failed, this, [this](const QString& message) {
    shell_.messages.show(MessageBar::Kind::Warning,
                         tr("What you said is not kept beside the recording."), message);
  });

  connect(&run_, &RunController::revisionReady, this, &RevisionActions::onReady);
  connect(&run_, &RunController::revisionProgressed, this, [this](double share) {
    left_.update(share, steadySeconds());
    const QString how_far = tr("%1: %2 %").arg(text_).arg(static_cast<int>(100.0 * share));
    shell_.messages.show(MessageBar::Kind::Info, how_far + left_.inWords(), {},
                         kRevisionActionsTopic);
    shell_.messages.addAction(tr("Cancel"), [this] { run_.dropRevision(); });
  });
  connect(&run_, &RunController::revisionFailed, this, [this](const Failure& failure) {
    forget();
    shell_.messages.show(MessageBar::Kind::Error, failure.message, failure.hint);
  });
  connect(&run_, &RunController::stateChanged, this, [this] {
    if (!run_.isRevising()) forget();
    updateActions();
  });
  connect(&document_, &MapDocument::mapChanged, this, &RevisionActions::updateActions);
  connect(&document_, &MapDocument::selectionChanged, this, &RevisionActions::updateActions);
  updateActions();
}

RevisionActions::~RevisionActions() {
  if (outcome_->scene() != nullptr) outcome_->scene()->removeItem(outcome_.get());
}

void RevisionActions::forget() {
  outcome_->setPoses({});
  outcome_->setBuildings({});
  shell_.messages.withdraw(kRevisionActionsTopic);
}

void RevisionActions::revise(const std::vector<StampedPose>& given, Then then,
                             const QString& text) {
  if (!run_.canRevise()) {
    shell_.messages.show(MessageBar::Kind::Warning,
                         tr("The beginning of the run is no longer kept."),
                         tr("Run its recording with the changed drawing."));
    return;
  }
  if (document_.map().buildings.empty() || !document_.map().start) {
    shell_.messages.show(MessageBar::Kind::Warning,
                         tr("A run needs at least one building and a start."));
    return;
  }
  then_ = then;
  text_ = text;
  left_.begin();
  run_.revise(document_.map(), given);
}

void RevisionActions::give(double time_s, const Pose2& pose) {
  say({{{time_s, Act::Kind::RobotIsHere, pose, {}, {}}}}, tr("Robot is here"),
      tr("Recomputing with the pose that you gave"));
}

/// What is said counts at once: the run is done again with it.
void RevisionActions::say(const std::vector<Said>& said, const QString& text, const QString& doing,
                          const std::function<void()>& change) {
  if (const auto folder = recordingFolder(); !folder.empty()) {
    for (const Said& one : said) recorder_.add(folder, one.act);
  }
  acts_.say(said, text, change);
  revise(acts_.poses(), Then::Take, doing);
}

void RevisionActions::connectSaid() {
  connect(&run_, &RunController::begun, this, [this] { acts_.begin(run_.settings().given_poses); });
  connect(&acts_, &SaidActs::wanted, this, &RevisionActions::onWanted);
  connect(&acts_, &SaidActs::changed, this, [this] {
    QStringList rows;
    for (const Said& said : acts_.all()) rows << inWords(said);
    panel_.setRows(rows);
  });
  connect(
      &panel_, &SaidPanel::takeBackWanted, &acts_,
      [this](int row) { acts_.takeBack(static_cast<std::size_t>(row)); },
      Qt::QueuedConnection);  // the row that was clicked goes
}

/// Something is no longer said, or is again.
void RevisionActions::onWanted() {
  if (!run_.history()) return;  // it is gone
  if (const auto folder = recordingFolder(); !folder.empty()) {
    recorder_.replace(folder, acts());
  }
  revise(acts_.poses(), Then::Take, tr("Recomputing with what is still said"));
}

std::vector<Act> RevisionActions::acts() const {
  std::vector<Act> acts;
  for (const Said& said : acts_.all()) acts.push_back(said.act);
  return acts;
}

QString RevisionActions::inWords(const Said& said) const {
  const auto of_building = [&](const QString& words) {
    return words.arg(QString::fromStdString(said.act.building));
  };
  QString words;
  switch (said.act.kind) {
    case Act::Kind::RobotIsHere:
      words = tr("The robot was at x %1 m, y %2 m")
                  .arg(said.act.pose.x, 0, 'f', 1)
                  .arg(said.act.pose.y, 0, 'f', 1);
      break;
    case Act::Kind::BuildingIsRight:
      words = of_building(tr("%1 is right"));
      break;
    case Act::Kind::BuildingIsNotThere:
      words = of_building(tr("%1 is not there"));
      break;
    case Act::Kind::ForgetPoses:
      words = tr("The poses given before do not count");
      break;
  }
  return tr("%1 s: %2").arg(said.act.time_s, 0, 'f', 1).arg(words);
}

void RevisionActions::takePoses(const std::vector<StampedPose>& poses) {
  acts_.givePoses(poses, tr("Open given poses"));
  revise(acts_.poses(), Then::Take, tr("Recomputing with the poses of the file"));
}

double RevisionActions::shownTime() const {
  const auto history = run_.history();
  const auto snapshot = history ? history->at(past_.playback().index()) : nullptr;
  return snapshot ? snapshot->report.time_s : 0.0;
}

std::filesystem::path RevisionActions::recordingFolder() const {
  const auto live = run_.live();
  const auto monitor = live ? live->monitor() : nullptr;
  const RecordingStatus recording = monitor ? monitor->status().recording : RecordingStatus();
  if (!recording.error.empty()) return {};
  return recording.folder;
}

/// As it is shown, which is corrected.
void RevisionActions::setRight() {
  const auto result = run_.result();
  if (!result) return;
  MapChange change;
  std::vector<Said> said;
  const auto snapshot = run_.history()->at(past_.playback().index());
  const auto places = placesOf(snapshot->map->buildings);
  for (Building& right : selected(document_.map(), document_.selection()).buildings) {
    const auto shown = places.find(right.id);
    if (shown == places.end()) continue;
    const Building before = right;
    right.shape = snapshot->map->buildings[shown->second].shape;
    right.fixed = true;
    said.push_back(
        {{snapshot->report.time_s, Act::Kind::BuildingIsRight, {}, right.id, right.shape}, before});
    change.buildings.push_back(right);
  }
  if (change.buildings.empty()) return;
  const QString text = tr("Building is right");
  say(said, text, tr("Recomputing with what is right"), [&] { document_.apply(change, text); });
}

void RevisionActions::removeNotThere() {
  std::vector<Said> said;
  QStringList keys;
  for (const Building& gone : selected(document_.map(), document_.selection()).buildings) {
    if (isLocked(document_.map(), gone)) continue;
    said.push_back({{shownTime(), Act::Kind::BuildingIsNotThere, {}, gone.id, {}}, gone});
    keys << QString::fromStdString(gone.id);
  }
  if (said.empty()) {
    shell_.messages.show(MessageBar::Kind::Info, tr("It is locked: unlock it first."));
    return;
  }
  say(said, tr("Building is not there"), tr("Recomputing without what is not there"),
      [&] { document_.remove(keys); });
}

void RevisionActions::onReady() {
  const auto before = run_.history()->at(run_.history()->newest());
  const auto after = run_.revision()->last;
  const QString words = differenceInWords(*before, *after);
  shell_.messages.withdraw(kRevisionActionsTopic);
  if (then_ == Then::Take) {
    run_.takeRevision();
    const bool said = !acts_.all().empty();
    shell_.messages.show(MessageBar::Kind::Info, tr("Done again. %1").arg(words),
                         said ? tr("Undo (Ctrl+Z) takes it back.") : QString(),
                         kRevisionActionsTopic);
    if (said) shell_.messages.addAction(tr("What you said"), [this] { shell_.docks.show(panel_); });
    return;
  }
  outcome_->setPoses(after->trajectory.all());
  outcome_->setBuildings(after->map->buildings);
  Message& question =
      shell_.messages.ask(tr("The run was done again with the changed drawing. %1").arg(words),
                          tr("The dashed outlines show the new result."), kRevisionActionsTopic);
  question.addAction(tr("Take the new result"), [this] { run_.takeRevision(); });
  question.addAction(tr("Keep the old result"), [this] { run_.dropRevision(); });
}

void RevisionActions::updateActions() {
  ActionSet& actions = shell_.actions;
  const bool can = run_.canRevise() && !run_.isRevising();
  const auto has_building = [this] {
    return !selected(document_.map(), document_.selection()).buildings.empty();
  };
  const QString why_not = whyNot();
  actions.setEnabled({"run.recompute"}, can && !(document_.map() == run_.drawing()),
                     can ? tr("the drawing is the one that was run with") : why_not);
  actions.setEnabled({"run.give_pose"}, can, why_not);
  actions["run.give_pose"].setVisible(run_.tape() != nullptr);
  actions.setEnabled({"run.right", "run.not_there"}, can && has_building(),
                     can ? tr("no building is selected") : why_not);
  actions.setEnabled({"run.forget_poses"}, can && !acts_.poses().empty(),
                     can ? tr("no pose was given") : why_not);
}

/// Why the run cannot be done again.
QString RevisionActions::whyNot() const {
  if (run_.isRevising()) return tr("the run is being done again");
  if (!run_.history() || run_.history()->empty()) return tr("no run shows a robot yet");
  if (run_.state() == RunState::Stopping) return tr("the run is ending");
  return tr("the beginning of the run is no longer kept");
}

}  // namespace handmap
