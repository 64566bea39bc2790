#include "app/gui/run/playback_actions.h"

#include <algorithm>

#include "app/gui/run/run_controller.h"
#include "widgets/actions/action_set.h"
#include "widgets/run/panels/timeline.h"
#include "widgets/run/panels/transport_bar.h"

namespace handmap {

PlaybackActions::PlaybackActions(const Shell& shell, RunController& run, TransportBar& transport,
                                 QObject* parent)
    : QObject(parent), shell_(shell), run_(run), transport_(transport) {
  const ActionSet& actions = shell_.actions;
  Timeline& timeline = transport_.timeline();
  actions.on("run.back", this, [this] {
    if (!run_.live()) run_.pause();
    playback_.stepBack();
  });
  actions.on("run.newest", this, [this] { playback_.toNewest(); });
  actions.on("run.bookmark", this, [this, &timeline] {
    timeline.toggleBookmark(playback_.index());
    updateActions();
  });
  actions.on("run.next_bookmark", this, [this, &timeline] {
    if (const auto next = timeline.nextBookmark()) seek(*next);
  });
  connect(&timeline, &Timeline::seekWanted, this, &PlaybackActions::seek);
  connect(&timeline, &Timeline::loopWanted, this, [this](std::optional<PlayRange> loop) {
    playback_.setLoop(loop);
    if (loop) seek(loop->first);
  });
  connect(&transport_, &TransportBar::speedChanged, &playback_, &Playback::setSpeed);
  connect(&playback_, &Playback::changed, this, &PlaybackActions::updateActions);
  playback_.setSpeed(transport_.speed());
  updateActions();
}

void PlaybackActions::begin() {
  last_report_.reset();
  usual_step_s_ = 0.0;
  done_ = 0;
  transport_.clearProgress();
  playback_.setHistory(run_.history());  // updates the actions
}

void PlaybackActions::onNews(const std::vector<FrameReport>& reports, int done, int count) {
  int index = done - static_cast<int>(reports.size());
  for (const FrameReport& report : reports) markGap(report, ++index);
  done_ = done;
  transport_.setExtent(done, count);
  updateActions();
}

/// What lasts long, or goes back, by the clock of the recording.
void PlaybackActions::markGap(const FrameReport& report, int index) {
  constexpr double kLong = 5.0;    // times the usual
  constexpr double kLong_s = 1.0;  // of many a second some always come late: no word of those
  constexpr double kShare = 0.1;   // of the newest step in the usual one
  Timeline& timeline = transport_.timeline();
  if (report.odometry_guessed) {
    timeline.addMark(index, TimelineMark::Guessed, tr("Motion guessed at %1").arg(report.time_s));
  }
  if (last_report_) {
    const double step_s = report.time_s - last_report_->time_s;
    const double long_s = std::max(kLong * usual_step_s_, kLong_s);
    if (step_s < 0.0 || (usual_step_s_ > 0.0 && step_s > long_s)) {
      const QString text = step_s < 0.0 ? tr("The clock went back by %1 s").arg(-step_s, 0, 'f', 1)
                                        : tr("Nothing came for %1 s").arg(step_s, 0, 'f', 1);
      timeline.addMark(index, TimelineMark::Gap, text);
      Q_EMIT noted(report.time_s, text);
    } else {
      usual_step_s_ += (usual_step_s_ > 0.0 ? kShare : 1.0) * (step_s - usual_step_s_);
    }
  }
  last_report_ = report;
}

void PlaybackActions::onSkipped(int frame, const QString& reason) {
  transport_.timeline().addMark(done_ + 1, TimelineMark::Skipped,
                                tr("Frame %1 was skipped: %2").arg(frame).arg(reason));
}

void PlaybackActions::showGiven(const std::vector<StampedPose>& given) {
  Timeline& timeline = transport_.timeline();
  timeline.removeMarks(TimelineMark::Given);
  if (playback_.history() == nullptr) return;
  for (const StampedPose& pose : given) {
    timeline.addMark(playback_.history()->indexAt(pose.time_s), TimelineMark::Given,
                     tr("You said where the robot was"));
  }
}

void PlaybackActions::seek(int index) {
  const RunState state = run_.state();
  const bool may_wait = !run_.live();
  if (index > done_) {
    playback_.toNewest();
    if (may_wait && (state == RunState::Running || state == RunState::Paused)) {
      run_.runUntil(index);
    }
    return;
  }
  if (may_wait) run_.pause();
  playback_.seek(index);
}

void PlaybackActions::seekTime(double time_s) {
  if (playback_.history() != nullptr) seek(playback_.history()->indexAt(time_s));
}

void PlaybackActions::updateActions() {
  const bool has_past = done_ > 0;
  const RunHistory* history = playback_.history();
  const bool has_before = has_past && history && playback_.index() > history->first();
  const auto next = transport_.timeline().nextBookmark();
  const QString nothing = tr("no run has seen anything yet");
  const ActionSet& actions = shell_.actions;
  actions.setEnabled({"run.back"}, has_before,
                     has_past ? tr("the first moment that is kept is shown") : nothing);
  actions.setEnabled({"run.bookmark"}, has_past, nothing);
  actions.setEnabled({"run.newest"}, has_past && !playback_.atNewest(),
                     has_past ? tr("the newest moment is shown") : nothing);
  actions.setEnabled({"run.next_bookmark"}, next && *next != playback_.index(),
                     tr("no other moment is marked"));
}

}  // namespace handmap
