#include "app/gui/run/run_controller.h"

#include <algorithm>
#include <utility>

#include "app/gui/run/live_robot.h"
#include "drivers/pace/paced_source.h"

namespace handmap {

namespace {
constexpr double kAtOnce = 0.0;
}

RunController::~RunController() { self_->cut(); }

std::shared_ptr<const RunResult> RunController::result() const {
  return worker_ ? worker_->result() : last_result_;
}

void RunController::start(const Map& drawing, const Robot& robot, const RunSetup& setup,
                          Begin begin) {
  Q_ASSERT(!isActive());
  dropRevision();
  drawing_ = drawing;
  settings_ = setup.settings;
  settings_.conclude_on_the_way = robot.live != nullptr || speed_ > kAtOnce;  // someone watches
  last_result_ = nullptr;
  at_end_ = false;
  live_ = robot.live;
  if (live_) {
    live_->whenPoseGiven([self = self_, link = live_.get()](double time_s, const Pose2& pose) {
      self->post([=](RunController& run) {
        if (run.isActive() && run.live_.get() == link) Q_EMIT run.poseGiven(time_s, pose);
      });
    });
    live_->begin();
  }
  ++number_;
  pace_ = std::make_shared<Pace>(begin == Begin::Running ? speed_ : kAtOnce);
  endFeed();
  feed_ = std::make_shared<RunFeed>(
      [connect = robot.connect, replay = setup.replay, pace = pace_, is_live = live_ != nullptr](
          std::stop_token stop,
          const std::function<void(double)>& progress) -> std::unique_ptr<ObservationSource> {
        auto source = connect(replay, stop, progress);
        if (!source || is_live) return source;
        return std::make_unique<PacedSource>(std::move(source), pace, std::move(stop));
      },
      settings_.perception, closing_);
  worker_ = std::make_unique<RunWorker>(RunJob{drawing, settings_, feed_});
  history_ = worker_->history();
  listenTo(*worker_);
  Q_EMIT begun();
  if (begin == Begin::WithOneStep) worker_->step();
  if (begin == Begin::WithPhases) worker_->stepPhases();
  worker_->start();
  setState(RunState::Running);
}

/// To the window, and to whoever looks on.
void RunController::pass(const RunNews& news) {
  if (live_) live_->tell(news.newest);
  Q_EMIT newsArrived(news);
}

void RunController::listenTo(RunWorker& worker) {
  worker.mailbox().setPrepare(prepare_);
  connect(&worker.mailbox(), &RunMailbox::arrived, this, &RunController::pass);
  connect(&worker, &RunWorker::started, this, &RunController::sourceOpened);
  connect(&worker, &RunWorker::progressed, this, &RunController::progressed);
  connect(&worker, &RunWorker::frameSkipped, this, &RunController::frameSkipped);
  connect(&worker, &RunWorker::paused, this, [this] {
    if (state_ != RunState::Stopping) setState(RunState::Paused);
  });
  connect(&worker, &RunWorker::resumed, this, [this] {
    if (state_ != RunState::Stopping) setState(RunState::Running);
  });
  connect(&worker, &RunWorker::finished, this, [this](bool cancelled) {
    at_end_ = !cancelled;
    end();
    Q_EMIT finished(cancelled);
  });
  connect(&worker, &RunWorker::failed, this, [this](const Failure& failure) {
    endFeed();
    end();
    Q_EMIT failed(failure);
  });
}

/// A recording that was stopped may go on, when it is recomputed; a drive that has ended is over.
void RunController::end() {
  if (at_end_ || live_) endFeed();
  last_result_ = worker_->result();
  letGo();
  setState(RunState::Idle);
}

void RunController::endFeed() {
  if (!feed_) return;
  feed_->end();
  closing_ = feed_->closed();
}

void RunController::letGo() {
  if (!worker_) return;
  worker_->disconnect();
  worker_->mailbox().disconnect();
  worker_->cancel();
  worker_.release()->deleteLater();
}

void RunController::pause() {
  if (!worker_) return;
  worker_->pause();
  pace_->setSpeed(kAtOnce);  // so that it does not sit waiting for the next observation
}

void RunController::resume() {
  if (!worker_) return;
  pace_->setSpeed(speed_);
  worker_->resume();
}

void RunController::step() {
  if (!worker_) return;
  pace_->setSpeed(kAtOnce);
  worker_->step();
}

void RunController::stepPhases() {
  if (!worker_) return;
  pace_->setSpeed(kAtOnce);
  worker_->stepPhases();
}

void RunController::runUntil(int index) {
  if (!worker_) return;
  pace_->setSpeed(kAtOnce);
  worker_->runUntil(index);
}

void RunController::stop() {
  if (!worker_) return;
  const bool may_finish = live_ && state_ != RunState::Stopping;
  if (may_finish) {
    live_->monitor()->end();
    worker_->resume();
  } else {
    worker_->cancel();
    pace_->setSpeed(kAtOnce);  // so that it does not sit waiting for the next observation
    if (live_) endFeed();
  }
  setState(RunState::Stopping);
}

void RunController::discard() {
  dropRevision();
  letGo();
  endFeed();
  ++number_;
  last_result_ = nullptr;
  feed_ = nullptr;
  history_ = nullptr;
  live_ = nullptr;
  drawing_ = {};
  setState(RunState::Idle);
}

void RunController::setSpeed(double speed) {
  speed_ = speed;
  if (pace_ && state_ == RunState::Running) pace_->setSpeed(speed_);
}

std::shared_ptr<const Tape> RunController::tape() const { return feed_ ? feed_->tape() : nullptr; }

bool RunController::canRevise() const {
  const auto perceived = tape();
  return perceived && perceived->begin() == 0 && history_ && !history_->empty() &&
         state_ != RunState::Stopping;
}

void RunController::revise(const Map& drawing, const std::vector<StampedPose>& given_poses) {
  if (!canRevise()) return;
  dropRevision();
  revision_ = std::make_unique<Revision>();
  revision_->goes_on = state_ == RunState::Running;
  if (!live_) pause();
  revision_->drawing = drawing;
  revision_->settings = settings_;
  revision_->settings.given_poses = given_poses;
  RunJob job;
  job.drawing = drawing;
  job.settings = revision_->settings;
  job.feed = feed_;
  job.until = at_end_ ? 0 : history_->newest();
  revision_->worker = std::make_unique<RunWorker>(std::move(job));
  listenToRevision();
  revision_->worker->start();
  Q_EMIT stateChanged(state_);
}

void RunController::listenToRevision() {
  RunWorker& worker = *revision_->worker;
  connect(&worker.mailbox(), &RunMailbox::arrived, this, [this](const RunNews& news) {
    RunNews& all = revision_->news;
    all.newest = news.newest;
    all.reports.insert(all.reports.end(), news.reports.begin(), news.reports.end());
    const int goal = std::max(1, history_ ? history_->newest() : 1);
    Q_EMIT revisionProgressed(std::min(1.0, static_cast<double>(news.newest->index) / goal));
  });
  const auto ready = [this](bool at_end) {
    revision_->at_end = at_end;
    if (!std::exchange(revision_->ready, true)) Q_EMIT revisionReady();
  };
  connect(&worker, &RunWorker::paused, this, [ready] { ready(false); });
  connect(&worker, &RunWorker::finished, this, [ready] { ready(true); });
  connect(&worker, &RunWorker::failed, this, [this](const Failure& failure) {
    dropRevision();
    Q_EMIT revisionFailed(failure);
  });
}

std::shared_ptr<const RunResult> RunController::revision() const {
  return revision_ && revision_->ready ? revision_->worker->result() : nullptr;
}

void RunController::takeRevision() {
  if (!revision()) return;
  const std::unique_ptr<Revision> revision = std::move(revision_);
  letGo();
  ++number_;
  worker_ = std::move(revision->worker);
  worker_->disconnect(this);
  worker_->mailbox().disconnect(this);
  drawing_ = std::move(revision->drawing);
  settings_ = std::move(revision->settings);
  worker_->history()->borrowPictures(*history_);
  history_ = worker_->history();
  revision->news.newest = history_->at(history_->newest());
  at_end_ = revision->at_end;
  Q_EMIT revised();
  pass(revision->news);
  if (at_end_) {
    end();
    Q_EMIT finished(false);
    return;
  }
  listenTo(*worker_);
  setState(RunState::Paused);
  if (revision->goes_on) resume();
}

void RunController::dropRevision() {
  if (!revision_) return;
  RunWorker& worker = *revision_->worker;
  worker.disconnect(this);
  worker.mailbox().disconnect(this);
  worker.cancel();
  revision_->worker.release()->deleteLater();  // it may be the sender
  revision_.reset();
  Q_EMIT stateChanged(state_);
}

void RunController::setState(RunState state) {
  if (state == state_) return;
  state_ = state;
  Q_EMIT stateChanged(state_);
}

}  // namespace handmap
