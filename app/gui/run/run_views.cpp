#include "app/gui/run/run_views.h"

#include "app/gui/run/run_controller.h"
#include "app/gui/run/run_log.h"
#include "app/gui/shell/docks.h"
#include "core/session/witness_windows.h"
#include "widgets/actions/action_set.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/document/map_document.h"
#include "widgets/run/overlays/building_hints.h"
#include "widgets/run/overlays/follow_robot.h"
#include "widgets/run/overlays/run_overlays.h"
#include "widgets/run/overlays/run_strip.h"
#include "widgets/run/panels/buildings_panel.h"
#include "widgets/run/panels/camera_panel.h"
#include "widgets/run/panels/charts_panel.h"
#include "widgets/run/panels/log_panel.h"
#include "widgets/run/panels/why_panel.h"
#include "widgets/run/words/phase_words.h"

namespace handmap {

namespace {

constexpr int kStoryAgain_ms = 1000;

}  // namespace

RunViews::RunViews(const Parts& parts, QObject* parent)
    : QObject(parent),
      parts_(parts),
      strip_(new RunStrip(parts.canvas)),
      follow_(new FollowRobot(parts.canvas, this)) {
  new RunLog(parts_.run, parts_.docks.log().model(), this);
  story_later_.setSingleShot(true);
  story_later_.setInterval(kStoryAgain_ms);
  connect(&story_later_, &QTimer::timeout, this, &RunViews::tellStory);
  connect(&parts_.overlays, &RunOverlays::shown, this, &RunViews::show);
  connect(&parts_.overlays, &RunOverlays::cleared, this, &RunViews::clear);
  connect(&parts_.overlays, &RunOverlays::outlinesChanged, &parts_.canvas,
          &MapCanvas::setLabelOutlines);
  ChartsPanel& charts = parts_.docks.charts();
  connect(&parts_.overlays, &RunOverlays::truthChanged, &charts, &ChartsPanel::setTruth);
  connect(&charts, &ChartsPanel::timeChosen, this, &RunViews::timeChosen);
  LogPanel& log = parts_.docks.log();
  connect(&log, &LogPanel::timeChosen, this, &RunViews::timeChosen);
  connect(&log, &LogPanel::showRequested, this, &RunViews::showBuilding);
  connect(&parts_.run, &RunController::revised, this, &RunViews::begin);
  connect(&teller_, &StoryTeller::told, this, &RunViews::hearStory);
  connectFollowing();
  connectTable();
  connectWhy();
}

void RunViews::connectFollowing() {
  parts_.actions.on("view.follow", follow_, [this] { follow_->next(); });
  parts_.actions.on("view.zoom_fit", follow_, [this] { follow_->setMode(FollowRobot::Mode::Off); });
  connect(strip_, &RunStrip::followRequested, follow_, &FollowRobot::next);
  connect(follow_, &FollowRobot::modeChanged, strip_, &RunStrip::setMode);
  connect(&parts_.canvas, &MapCanvas::turned, &parts_.overlays, &RunOverlays::setViewTurn);
}

void RunViews::connectTable() {
  BuildingsPanel& table = parts_.docks.buildings();
  MapDocument& document = parts_.document;
  connect(&table, &BuildingsPanel::selectionChanged, &document, &MapDocument::setSelection);
  connect(&document, &MapDocument::selectionChanged, &table,
          [&table, &document] { table.select(document.selection()); });
  connect(&table, &BuildingsPanel::showRequested, this, &RunViews::showBuilding);
}

void RunViews::connectWhy() {
  WhyPanel& why = parts_.docks.why();
  auto* hints = new BuildingHints(parts_.canvas, parts_.overlays, this);
  connect(hints, &BuildingHints::wallClicked, this, [this](std::size_t building, std::size_t wall) {
    if (parts_.docks.isWhyShown()) parts_.docks.why().ask(building, wall);
  });
  connect(&why, &WhyPanel::wallAsked, this, &RunViews::tellStory);
  connect(&why, &WhyPanel::nothingAsked, this, &RunViews::forgetStory);
  connect(&why, &WhyPanel::timeChosen, this, &RunViews::timeChosen);
  connect(&why, &WhyPanel::witnessChosen, this, [this](std::optional<std::size_t> witness) {
    if (story_) parts_.overlays.showStory(story_.get(), witness);
  });
  connect(&parts_.docks, &Docks::whyShown, this,
          [this](bool shown) { shown ? tellStory() : forgetStory(); });
  parts_.actions.on("run.why", this, [this] { parts_.docks.showWhy(); });
}

void RunViews::begin() {
  const Map& drawing = parts_.run.drawing();
  parts_.overlays.setDrawing(drawing);
  parts_.docks.charts().setDrawing(drawing);
  parts_.docks.charts().setTruthMap(parts_.overlays.truthMap());
  parts_.docks.buildings().model().setTruth(parts_.overlays.truthMap());
  parts_.docks.buildings().model().setDrawing(drawing);
}

void RunViews::showPhase(const Phase& phase, int number, int count) {
  parts_.overlays.showPhase(phase);
  const Map* map = parts_.overlays.shownMap();
  strip_->show(phase.shown.report, map ? *map : parts_.overlays.drawing());
  strip_->showPhase(tr("Phase %1 of %2: %3. %4")
                        .arg(number)
                        .arg(count)
                        .arg(PhaseWords::name(phase), PhaseWords::change(phase)));
  follow_->setPose(phase.shown.report.pose);
}

void RunViews::show(const Snapshot& snapshot) {
  const Map* map = parts_.overlays.shownMap();
  strip_->showPhase({});
  strip_->show(snapshot.report, map ? *map : parts_.overlays.drawing());
  follow_->setPose(snapshot.report.pose);
  parts_.docks.charts().addSnapshot(snapshot);
  parts_.docks.charts().setCursor(snapshot.report.time_s);
  showWindows();
  if (!map || !parts_.docks.isWhyShown()) return;
  parts_.docks.why().setMap(*map);
  if (story_ && !story_later_.isActive()) story_later_.start();
}

void RunViews::clear() {
  strip_->showNothing();
  follow_->forgetPose();
  story_later_.stop();
  parts_.docks.why().clear();
  forgetStory();
}

void RunViews::showBuilding(const QString& id) {
  parts_.document.setSelection({id});
  parts_.canvas.zoomToObject(id);
}

void RunViews::tellStory() {
  WhyPanel& why = parts_.docks.why();
  const Map* map = parts_.overlays.shownMap();
  if (map == nullptr || !parts_.docks.isWhyShown()) return;
  if (!why.asked()) why.setMap(*map);
  const auto asked = why.asked();
  if (!asked) return forgetStory();
  teller_.ask({parts_.overlays.drawing(), *map, parts_.overlays.shownWay(), parts_.run.tape(),
               asked->building, asked->wall});
}

void RunViews::hearStory(const std::shared_ptr<const WallStory>& story, bool kept) {
  story_ = story;
  parts_.docks.why().setStory(*story_, kept);
  parts_.overlays.showStory(story_.get(), {});
  showWindows();
}

void RunViews::forgetStory() {
  teller_.forget();
  story_.reset();
  parts_.overlays.showStory(nullptr, {});
  showWindows();
}

/// Of the look that the camera panel shows, where it is one of those that placed the wall.
void RunViews::showWindows() {
  CameraPanel& camera = parts_.docks.camera();
  const auto tape = parts_.run.tape();
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
