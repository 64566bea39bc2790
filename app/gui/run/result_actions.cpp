#include "app/gui/run/result_actions.h"

#include <QMainWindow>
#include <algorithm>
#include <span>

#include "app/gui/files/file_actions.h"
#include "app/gui/run/live_robot.h"
#include "app/gui/run/run_controller.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/shell/docks.h"
#include "core/map/certainty.h"
#include "core/map/concerns.h"
#include "core/map/map_changes.h"
#include "widgets/actions/action_set.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/dialogs.h"
#include "widgets/messages/message_bar.h"
#include "widgets/run/panels/buildings_panel.h"
#include "widgets/run/words/words.h"

namespace handmap {

namespace {

constexpr auto kAcceptTopic = "accept";
constexpr auto kSummaryTopic = "summary";
constexpr std::size_t kMostDoubtfulOffered = 3;
constexpr qsizetype kMostEditedNamed = 8;
constexpr auto kConcernsTopic = "concerns";
constexpr qsizetype kMostConcernsTold = 3;

}  // namespace

ResultActions::ResultActions(const Shell& shell, MapDocument& document, FileActions& files,
                             const SourceActions& sources, RunController& run,
                             BuildingsPanel& buildings)
    : QObject(&shell.window),
      shell_(shell),
      document_(document),
      files_(files),
      sources_(sources),
      run_(run),
      buildings_(buildings) {
  const ActionSet& actions = shell_.actions;
  actions.on("run.accept", this, [this] { accept(); });
  connect(&buildings_, &BuildingsPanel::acceptRequested, this, &ResultActions::accept);
  files_.setMayLeaveRun([this](bool coming_back) { return mayLeave(coming_back); });
  connect(&files_, &FileActions::drawingReplaced, this, &ResultActions::forget);
  connect(&sources_, &SourceActions::robotChanged, this, &ResultActions::forget);
  connect(&run_, &RunController::begun, this, [this] { skipped_ = 0; });
  connect(&run_, &RunController::frameSkipped, this, &ResultActions::onFrameSkipped);
  connect(&run_, &RunController::finished, this, &ResultActions::onFinished);
  connect(&run_, &RunController::stateChanged, this, &ResultActions::updateActions);
  connect(&run_, &RunController::newsArrived, this, &ResultActions::updateActions);
  updateActions();
}

void ResultActions::updateActions() {
  shell_.actions.setEnabled({"run.accept"}, run_.result() != nullptr,
                            tr("no run has corrected anything yet"));
}

/// Another robot, or another drawing: nothing is left to be accepted.
void ResultActions::forget() {
  for (const char* topic : {kAcceptTopic, kSummaryTopic, kConcernsTopic})
    shell_.messages.withdraw(topic);
  updateActions();
}

void ResultActions::onFrameSkipped(int frame, const QString& reason) {
  ++skipped_;
  const QString what =
      skipped_ == 1
          ? tr("Frame %1 was skipped: %2").arg(frame).arg(reason)
          : tr("%1 frames were skipped; the latest, %2: %3").arg(skipped_).arg(frame).arg(reason);
  shell_.messages.show(MessageBar::Kind::Warning, what, {}, QStringLiteral("skipped"));
}

void ResultActions::onFinished(bool cancelled) {
  if (run_.result()) shell_.docks.bringForward(buildings_);
  if (cancelled) return;
  if (!warn() && skipped_ == 0) {
    if (const auto result = score()) summarize(*result);
  }
  alarm();
}

/// Buildings that stand in each other, or are far from where the drawing says that they may be.
void ResultActions::alarm() {
  const auto result = run_.result();
  if (!result) return;
  const Map& drawing = run_.drawing();
  QStringList lines;
  QStringList ids;
  for (const Concern& concern : concernsOf(drawing, result->map())) {
    const bool told_from_the_other =
        concern.kind == Concern::Kind::Overlaps && concern.other < concern.building;
    if (told_from_the_other) continue;
    lines << Words::concern(concern, drawing);
    const QString id = QString::fromStdString(drawing.buildings[concern.building].id);
    if (!ids.contains(id)) ids << id;
  }
  if (lines.isEmpty()) return;
  const qsizetype more = lines.size() - kMostConcernsTold;
  QString text = lines.mid(0, kMostConcernsTold).join(tr("; "));
  if (more > 0) text += tr("; and %n more", nullptr, static_cast<int>(more));
  shell_.messages.show(MessageBar::Kind::Warning, tr("Look before you accept: %1.").arg(text),
                       tr("Hatched on the map."), kConcernsTopic);
  for (const QString& id : ids.mid(0, static_cast<qsizetype>(kMostDoubtfulOffered)))
    shell_.messages.addAction(id, [this, id] { Q_EMIT buildings_.showRequested(id); });
}

bool ResultActions::warn() {
  const auto result = run_.result();
  if (!result) return false;
  for (const RunWarning& warning : result->warnings) {
    shell_.messages
        .show(MessageBar::Kind::Warning, QString::fromStdString(warning.message),
              QString::fromStdString(warning.hint))
        .addAction(tr("Place the start"), [this] { shell_.actions["draw.start"].trigger(); });
  }
  // A gap in a drive that is right otherwise does not make its outcome worthless.
  return std::ranges::any_of(result->warnings, [](const RunWarning& warning) {
    return warning.code != "part_unrecognised";
  });
}

void ResultActions::summarize(const RunScore& score) {
  const Map& drawing = run_.drawing();
  const MapChanges changes = changesOf(drawing, run_.result()->map());
  Message& summary = shell_.messages.show(
      MessageBar::Kind::Info, tr("The run is done. %1").arg(Words::changes(changes, drawing)),
      scoreInWords(score), kSummaryTopic);
  const std::size_t offered = std::min(changes.doubtful.size(), kMostDoubtfulOffered);
  for (const BuildingChange& change : std::span(changes.doubtful).first(offered)) {
    const QString id = QString::fromStdString(drawing.buildings[change.building].id);
    summary.addAction(
        id, [this, id] { Q_EMIT buildings_.showRequested(id); }, Message::Then::Stay);
  }
  summary.addAction(
      tr("Review…"), [this] { shell_.docks.show(buildings_); }, Message::Then::Stay);
  summary.addAction(tr("Accept correction"), [this, number = run_.number()] {
    if (number == run_.number()) accept();
  });
}

std::optional<RunScore> ResultActions::score() const {
  const auto result = run_.result();
  const auto tape = run_.tape();
  const auto& robot = sources_.robot();
  if (!result || !tape || !robot) return std::nullopt;
  return scoreRun(run_.drawing(), result->map(), robot->truth_map, *result->last,
                  tape->info().truth);
}

void ResultActions::accept() {
  const auto result = run_.result();
  if (!result) return;
  const int number = run_.number();
  const QStringList left_out = buildings_.model().leftOut();
  QStringList edited = document_.editedSince(run_.drawing());
  edited.removeIf([&left_out](const QString& id) { return left_out.contains(id); });
  if (edited.isEmpty()) return take(left_out);
  Message& question = shell_.messages.ask(
      tr("%n building(s) were edited since the run began: %1", nullptr,
         static_cast<int>(edited.size()))
          .arg(edited.mid(0, kMostEditedNamed).join(QStringLiteral(", "))),
      tr("Their corrected shapes belong to the drawing as it was before."), kAcceptTopic);
  question.addAction(tr("Take all others"), [this, number, kept = edited + left_out] {
    if (number == run_.number()) take(kept);
  });
  question.addAction(tr("Take all"), [this, number, left_out] {
    if (number == run_.number()) take(left_out);
  });
}

void ResultActions::take(const QStringList& kept) {
  if (!document_.acceptRefinement(run_.result()->map(), kept)) {
    shell_.messages.show(MessageBar::Kind::Info,
                         tr("The drawing has all of it already: there is nothing to take."), {},
                         kAcceptTopic);
  }
  accepted_ = run_.number();
  shell_.messages.withdraw(kConcernsTopic);
  shell_.messages.withdraw(kSummaryTopic);
}

// --- Leaving

/// What a simulator gave can be had again.
bool ResultActions::isSimulated() const {
  const auto& robot = sources_.robot();
  return !robot || robot->truth_map.has_value();
}

bool ResultActions::isUnrecorded() const {
  const auto live = run_.live();
  if (!live || isSimulated() || left_ == run_.number()) return false;
  if (!run_.history() || run_.history()->empty()) return false;
  const auto monitor = live->monitor();
  if (!monitor) return false;
  const RecordingStatus recording = monitor->status().recording;
  return recording.folder.empty() || !recording.error.empty();
}

/// Somebody's robot: leaving would end its drive.
bool ResultActions::isDriving() const {
  return run_.live() && run_.isActive() && !isSimulated() && left_ != run_.number();
}

bool ResultActions::isUnaccepted() const {
  const auto result = run_.result();
  if (!result || run_.isActive() || isSimulated()) return false;
  const Map& map = result->map();
  const bool in_drawing =
      accepted_ == run_.number() && document_.map().refinement == map.refinement;  // not undone
  if (in_drawing || left_ == run_.number()) return false;
  return std::ranges::any_of(map.buildings, [](const Building& building) {
    return !building.fixed && isRecognised(building);
  });
}

bool ResultActions::mayLeave(bool coming_back) {
  const bool unrecorded = isUnrecorded();
  const bool unaccepted = isUnaccepted();
  const bool driving = isDriving() && !unrecorded;
  if (!unrecorded && !driving && (!unaccepted || (coming_back && !run_.live()))) return true;
  const QString text = driving ? tr("The drive goes on. What was recorded of it stays, the rest is "
                                    "missed.")
                       : !unaccepted ? tr("The drive was not recorded: it cannot be run again.")
                       : unrecorded ? tr("The drive was not recorded: it cannot be run again. What "
                                         "it has corrected is not in the drawing.")
                                    : tr("What the run has corrected is not in the drawing.");
  const QStringList answers = unaccepted
                                  ? QStringList{tr("&Accept correction"), tr("&Leave it behind")}
                                  : QStringList{tr("&Leave it behind")};
  const int answer = shell_.dialogs.choose({tr("Leave this run?"), text, answers});
  if (answer < 0) return false;
  if (unaccepted && answer == 0)
    take(document_.editedSince(run_.drawing()) + buildings_.model().leftOut());
  left_ = run_.number();
  return true;
}

}  // namespace handmap
