#include "app/gui/run/revision_actions.h"

#include <QGraphicsScene>
#include <algorithm>

#include "app/gui/run/live_robot.h"
#include "app/gui/run/playback_actions.h"
#include "app/gui/run/run_controller.h"
#include "core/map/places.h"
#include "core/session/redone_acts.h"
#include "widgets/actions/action_set.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/message_bar.h"
#include "widgets/run/overlays/path_item.h"
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
  const QString robot = RevisionActions::tr("the robot is %1 m elsewhere").arg(pose, 0, 'f', 2);
  if (moved == 0) return RevisionActions::tr("No building moves; %1.").arg(robot);
  return RevisionActions::tr("%n building(s) move by up to %1 m; %2.", nullptr, moved)
      .arg(farthest, 0, 'f', 1)
      .arg(robot);
}

RevisionActions::RevisionActions(const Shell& shell, MapDocument& document, RunController& run,
                                 MapCanvas& canvas, Toolbox& tools, PlaybackActions& past)
    : shell_(shell),
      document_(document),
      run_(run),
      canvas_(canvas),
      tools_(tools),
      past_(past),
      outcome_(std::make_unique<PathItem>(Role::Preview)) {
  outcome_->setZValue(kOverlayZ + 50.0);
  canvas_.scene()->addItem(outcome_.get());
  const ActionSet& actions = shell_.actions;
  actions.on("run.recompute", this, [this] {
    revise(run_.settings().given_poses, Then::Ask, tr("Recomputing with the drawing as it is"));
  });
  actions.on("run.right", this, [this] { setRight(); });
  actions.on("run.not_there", this, [this] { removeNotThere(); });
  actions.on("run.forget_poses", this, [this] {
    keep({shownTime(), Act::Kind::ForgetPoses, {}, {}, {}});
    revise({}, Then::Take, tr("Recomputing without the poses that were given"));
  });
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
                         tr("The beginning of the run is no longer in memory."),
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
  std::vector<StampedPose> given = run_.settings().given_poses;
  handmap::give(given, {time_s, pose});
  keep({time_s, Act::Kind::RobotIsHere, pose, {}, {}});
  revise(given, Then::Take, tr("Recomputing with the pose that you gave"));
}

void RevisionActions::takePoses(const std::vector<StampedPose>& poses) {
  revise(poses, Then::Take, tr("Recomputing with the poses of the file"));
}

double RevisionActions::shownTime() const {
  const auto history = run_.history();
  const auto snapshot = history ? history->at(past_.playback().index()) : nullptr;
  return snapshot ? snapshot->report.time_s : 0.0;
}

void RevisionActions::keep(const Act& act) {
  const auto live = run_.live();
  const auto monitor = live ? live->monitor() : nullptr;
  const RecordingStatus recording = monitor ? monitor->status().recording : RecordingStatus();
  if (recording.folder.empty() || !recording.error.empty()) return;
  recorder_.add(recording.folder, act);
}

/// As it is shown, which is corrected.
void RevisionActions::setRight() {
  const auto result = run_.result();
  if (!result) return;
  MapChange change;
  const auto snapshot = run_.history()->at(past_.playback().index());
  const auto places = placesOf(snapshot->map->buildings);
  for (Building& right : selected(document_.map(), document_.selection()).buildings) {
    const auto shown = places.find(right.id);
    if (shown == places.end()) continue;
    right.shape = snapshot->map->buildings[shown->second].shape;
    right.fixed = true;
    keep({snapshot->report.time_s, Act::Kind::BuildingIsRight, {}, right.id, right.shape});
    change.buildings.push_back(right);
  }
  if (change.buildings.empty()) return;
  document_.apply(change, tr("Building is right"));
  revise(run_.settings().given_poses, Then::Take, tr("Recomputing with what is right"));
}

void RevisionActions::removeNotThere() {
  for (const Building& gone : selected(document_.map(), document_.selection()).buildings)
    keep({shownTime(), Act::Kind::BuildingIsNotThere, {}, gone.id, {}});
  document_.removeSelected();
  revise(run_.settings().given_poses, Then::Take, tr("Recomputing without what is not there"));
}

void RevisionActions::onReady() {
  const auto before = run_.history()->at(run_.history()->newest());
  const auto after = run_.revision()->last;
  const QString words = differenceInWords(*before, *after);
  shell_.messages.withdraw(kRevisionActionsTopic);
  if (then_ == Then::Take) {
    run_.takeRevision();
    shell_.messages.show(MessageBar::Kind::Info, tr("Done again. %1").arg(words), {},
                         kRevisionActionsTopic);
    return;
  }
  outcome_->setPoses(after->trajectory.all());
  outcome_->setBuildings(after->map->buildings);
  Message& question =
      shell_.messages.ask(tr("The run was done again with the changed drawing. %1").arg(words),
                          tr("The dashed outlines show what came of it."), kRevisionActionsTopic);
  question.addAction(tr("Take the new one"), [this] { run_.takeRevision(); });
  question.addAction(tr("Keep what was"), [this] { run_.dropRevision(); });
}

void RevisionActions::updateActions() {
  ActionSet& actions = shell_.actions;
  const bool can = run_.canRevise() && !run_.isRevising();
  const auto has_building = [this] {
    return !selected(document_.map(), document_.selection()).buildings.empty();
  };
  actions.setEnabled({"run.recompute"}, can && !(document_.map() == run_.drawing()));
  actions.setEnabled({"run.give_pose"}, can);
  actions.setEnabled({"run.right", "run.not_there"}, can && has_building());
  actions.setEnabled({"run.forget_poses"}, can && !run_.settings().given_poses.empty());
}

}  // namespace handmap
