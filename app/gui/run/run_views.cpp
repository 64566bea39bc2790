#include "app/gui/run/run_views.h"

#include <QMainWindow>
#include <algorithm>

#include "app/gui/files/file_actions.h"
#include "app/gui/run/log_keeper.h"
#include "app/gui/run/run_controller.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/shell/docks.h"
#include "core/explain/witness_windows.h"
#include "widgets/actions/action_set.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/document/map_document.h"
#include "widgets/run/overlays/building_hints.h"
#include "widgets/run/overlays/follow_robot.h"
#include "widgets/run/overlays/robot_pointer.h"
#include "widgets/run/overlays/run_overlays.h"
#include "widgets/run/overlays/run_strip.h"
#include "widgets/run/panels/buildings_panel.h"
#include "widgets/run/panels/camera_panel.h"
#include "widgets/run/panels/charts_panel.h"
#include "widgets/run/panels/layers_panel.h"
#include "widgets/run/panels/log_panel.h"
#include "widgets/run/panels/why_panel.h"
#include "widgets/run/words/phase_words.h"

namespace handmap {

namespace {

constexpr int kStoryAgain_ms = 1000;

}  // namespace

RunViews::RunViews(const Shell& shell, MapCanvas& canvas, MapDocument& document, FileActions& files,
                   const SourceActions& sources, RunController& run, RunOverlays& overlays,
                   const RunPanels& panels)
    : QObject(&shell.window),
      shell_(shell),
      canvas_(canvas),
      document_(document),
      sources_(sources),
      run_(run),
      overlays_(overlays),
      panels_(panels),
      strip_(new RunStrip(canvas)),
      follow_(new FollowRobot(canvas, this)),
      pointer_(new RobotPointer(canvas)) {
  new LogKeeper(run_, panels_.log.model(), this);
  story_later_.setSingleShot(true);
  story_later_.setInterval(kStoryAgain_ms);
  connect(&story_later_, &QTimer::timeout, this, &RunViews::tellStory);
  connect(&overlays_, &RunOverlays::shown, this, &RunViews::onShown);
  connect(&overlays_, &RunOverlays::cleared, this, &RunViews::clear);
  connect(&overlays_, &RunOverlays::outlinesChanged, &canvas_, &MapCanvas::setLabelOutlines);
  connect(&overlays_, &RunOverlays::truthChanged, &panels_.charts, &ChartsPanel::setTruth);
  connect(&panels_.charts, &ChartsPanel::timeChosen, this, &RunViews::timeChosen);
  connect(&panels_.log, &LogPanel::timeChosen, this, &RunViews::timeChosen);
  connect(&panels_.log, &LogPanel::showRequested, this, &RunViews::showBuilding);
  connect(&sources_, &SourceActions::robotChanged, this, &RunViews::forget);
  connect(&files, &FileActions::drawingReplaced, this, &RunViews::forget);
  connectRun();
  connect(&teller_, &StoryTeller::told, this, &RunViews::hearStory);
  connectFollowing();
  connectTable();
  connectWhy();
}

void RunViews::connectRun() {
  connect(&run_, &RunController::begun, this, [this] {
    panels_.charts.clear();
    panels_.charts.showSampleSize(run_.settings().method == Method::Paper);
    panels_.camera.setSnapshot(nullptr);
    panels_.buildings.model().setDrawing(run_.drawing());
  });
  connect(&run_, &RunController::sourceOpened, this,
          [this](const std::shared_ptr<const SourceInfo>& source) {
            showTruth(source->truth);
            const bool has_camera = source->camera.has_value();
            shell_.docks.showRunDocks(true, has_camera);
            panels_.layers.setRun(true, run_.settings().method == Method::Paper);
            if (has_camera) shell_.docks.bringForward(panels_.camera);
            compare();
          });
  connect(&run_, &RunController::newsArrived, this,
          [this](const RunNews& news) { panels_.charts.add(news.reports); });
  connect(&run_, &RunController::revised, this, [this] {
    panels_.charts.clear();
    compare();
  });
}

/// Another robot, or another drawing: of the run there was nothing is left.
void RunViews::forget() {
  overlays_.clear();
  const auto& robot = sources_.robot();
  showTruth(robot ? robot->truth : std::vector<StampedPose>());
  if (robot && robot->truth_map) overlays_.setTruthMap(*robot->truth_map);
  panels_.buildings.model().setDrawing({});
  shell_.docks.showRunDocks(false, false);
  panels_.layers.setRun(false, false);
}

void RunViews::showTruth(const std::vector<StampedPose>& trajectory) {
  const auto& robot = sources_.robot();
  overlays_.setTruth(trajectory);
  panels_.layers.setAvailable(Layer::Truth, !trajectory.empty() || (robot && robot->truth_map));
}

void RunViews::connectFollowing() {
  shell_.actions.on("view.follow", follow_, [this] { follow_->next(); });
  shell_.actions.on("view.zoom_fit", follow_, [this] { follow_->setMode(FollowRobot::Mode::Off); });
  connect(strip_, &RunStrip::followRequested, follow_, &FollowRobot::next);
  connect(follow_, &FollowRobot::modeChanged, strip_, &RunStrip::setMode);
  connect(&canvas_, &MapCanvas::turned, &overlays_, &RunOverlays::setViewTurn);
  // While it runs one looks at the robot; a hand that moves the map ends that.
  connect(&run_, &RunController::begun, follow_,
          [this] { follow_->setMode(FollowRobot::Mode::Follow); });
  connect(&run_, &RunController::finished, follow_, [this] {
    if (follow_->mode() == FollowRobot::Mode::Follow) follow_->setMode(FollowRobot::Mode::Off);
  });
  connect(&document_, &MapDocument::mapChanged, this,
          [this] { overlays_.setOnPicture(!document_.map().underlays.empty()); });
  showRobotAt({});
}

void RunViews::showRobotAt(const std::optional<Pose2>& pose) {
  pose ? follow_->setPose(*pose) : follow_->forgetPose();
  pointer_->setPose(pose);
  shell_.actions.setEnabled({"view.follow"}, pose.has_value(), tr("no run shows a robot yet"));
}

void RunViews::connectTable() {
  BuildingsPanel& table = panels_.buildings;
  MapDocument& document = document_;
  connect(&table, &BuildingsPanel::selectionChanged, this, [this](const QStringList& ids) {
    document_.setSelection(ids);
    // One after the other is looked at, once the robot is not looked after any more.
    if (ids.size() == 1 && !run_.isActive()) showBuilding(ids.first());
  });
  connect(&document, &MapDocument::selectionChanged, &table,
          [&table, &document] { table.select(document.selection()); });
  connect(&table, &BuildingsPanel::showRequested, this, &RunViews::showBuilding);
}

void RunViews::connectWhy() {
  WhyPanel& why = panels_.why;
  auto* hints = new BuildingHints(canvas_, overlays_, this);
  connect(hints, &BuildingHints::wallClicked, this, [this](std::size_t building, std::size_t wall) {
    if (panels_.why.isVisible()) panels_.why.ask(building, wall);
  });
  connect(&why, &WhyPanel::wallAsked, this, &RunViews::tellStory);
  connect(&why, &WhyPanel::nothingAsked, this, &RunViews::forgetStory);
  connect(&why, &WhyPanel::timeChosen, this, &RunViews::timeChosen);
  connect(&why, &WhyPanel::witnessChosen, this, [this](std::optional<std::size_t> witness) {
    if (story_) overlays_.showStory(story_.get(), witness);
  });
  connect(&why, &WhyPanel::shown, this,
          [this](bool shown) { shown ? tellStory() : forgetStory(); });
  canvas_.setCorrectedAt([hints](const Vec2& metres) { return hints->buildingAt(metres); });
  shell_.actions.on("run.why", this, [this] { askWhy(); });
  connect(&document_, &MapDocument::selectionChanged, this,
          [this] { overlays_.setSelected(document_.selection()); });
  updateWhy();
}

/// With the drawing, and with the truth where it is known.
void RunViews::compare() {
  const Map& drawing = run_.drawing();
  overlays_.setDrawing(drawing);
  panels_.charts.setDrawing(drawing);
  panels_.charts.setTrueMiddles(overlays_.trueMiddles());
  panels_.buildings.model().setTruth(overlays_.trueMiddles());
  panels_.buildings.model().setDrawing(drawing);
}

void RunViews::note(double time_s, const QString& text) {
  panels_.log.model().add({time_s, LogKind::Warning, text, {}});
}

void RunViews::showPicture(const std::shared_ptr<const Snapshot>& snapshot) {
  panels_.camera.setSnapshot(snapshot);
}

void RunViews::show(const Snapshot& snapshot) {
  overlays_.show(snapshot);
  panels_.buildings.model().setRefined(*snapshot.map);
}

void RunViews::showPhase(const Phase& phase, int number, int count) {
  overlays_.showPhase(phase);
  const Map* map = overlays_.shownMap();
  strip_->show(phase.shown.report, map ? *map : overlays_.drawing());
  strip_->showPhase(tr("Phase %1 of %2: %3. %4")
                        .arg(number)
                        .arg(count)
                        .arg(PhaseWords::name(phase), PhaseWords::change(phase)));
  showRobotAt(phase.shown.report.pose);
}

void RunViews::onShown(const Snapshot& snapshot) {
  const Map* map = overlays_.shownMap();
  updateWhy();
  canvas_.setRunShown(true);
  strip_->showPhase({});
  strip_->show(snapshot.report, map ? *map : overlays_.drawing());
  showRobotAt(snapshot.report.pose);
  panels_.charts.addSnapshot(snapshot);
  panels_.charts.setCursor(snapshot.report.time_s);
  showWindows();
  if (!map || !panels_.why.isVisible()) return;
  panels_.why.setMap(*map);
  if (story_ && !story_later_.isActive()) story_later_.start();
}

void RunViews::clear() {
  strip_->showNothing();
  canvas_.setRunShown(false);
  showRobotAt({});
  story_later_.stop();
  panels_.why.clear();
  forgetStory();
  updateWhy();
}

/// As it is drawn and as it is corrected.
void RunViews::showBuilding(const QString& id) {
  document_.setSelection({id});
  const Map* corrected = overlays_.shownMap();
  const auto drawn = boundsOf(document_.map(), id);
  const Building* now = corrected ? corrected->find(id.toStdString()) : nullptr;
  if (!drawn || now == nullptr) return canvas_.zoomToObject(id);
  const Bounds after = boundsOf(*now);
  const Vec2 low = drawn->low.cwiseMin(after.low);
  const Vec2 size = drawn->high.cwiseMax(after.high) - low;
  canvas_.zoomToArea(QRectF(low.x(), low.y(), size.x(), size.y()));
}

/// Of the building that is selected; where its menu was opened, of the wall that is nearest.
void RunViews::askWhy() {
  shell_.docks.show(panels_.why);
  const Map* map = overlays_.shownMap();
  const auto at = canvas_.takeMenuPlace();
  const QStringList keys = document_.selection();
  if (map == nullptr || keys.size() != 1) return;
  const auto found = std::ranges::find(map->buildings, keys.first().toStdString(), &Building::id);
  if (found == map->buildings.end()) return;
  const Polygon outline = found->footprint();
  std::size_t nearest = 0;
  const auto distance = [&](std::size_t wall) {
    return distanceTo(Segment{outline[wall], outline[(wall + 1) % outline.size()]}, *at);
  };
  for (std::size_t wall = 1; at && wall < outline.size(); ++wall)
    if (distance(wall) < distance(nearest)) nearest = wall;
  panels_.why.ask(static_cast<std::size_t>(found - map->buildings.begin()), nearest);
}

void RunViews::updateWhy() {
  shell_.actions.setEnabled({"run.why"}, overlays_.shownMap() != nullptr,
                            tr("no run has corrected anything yet"));
}

void RunViews::tellStory() {
  WhyPanel& why = panels_.why;
  const Map* map = overlays_.shownMap();
  if (map == nullptr || !panels_.why.isVisible()) return;
  if (!why.asked()) why.setMap(*map);
  const auto asked = why.asked();
  if (!asked) return forgetStory();
  teller_.ask({overlays_.drawing(), *map, overlays_.shownTrajectory(), run_.tape(), asked->building,
               asked->wall});
}

void RunViews::hearStory(const std::shared_ptr<const WallStory>& story, bool kept) {
  story_ = story;
  panels_.why.setStory(*story_, kept);
  overlays_.showStory(story_.get(), {});
  showWindows();
}

void RunViews::forgetStory() {
  teller_.forget();
  story_.reset();
  overlays_.showStory(nullptr, {});
  showWindows();
}

/// Of the look that the camera panel shows, where it is one of those that placed the wall.
void RunViews::showWindows() {
  CameraPanel& camera = panels_.camera;
  const auto tape = run_.tape();
  const Snapshot* shown = camera.snapshot();
  if (!story_ || !tape || !tape->info().camera || shown == nullptr || shown->image.empty() ||
      shown->pictured != shown->report.frame) {
    return camera.setWitnesses({});
  }
  for (const WallWitness& witness : story_->witnesses) {
    if (witness.time_s != shown->report.time_s) continue;
    return camera.setWitnesses(windowsOf(witness, *tape->info().camera, shown->panning.pan,
                                         shown->buildings, shown->image.size()));
  }
  camera.setWitnesses({});
}

}  // namespace handmap
