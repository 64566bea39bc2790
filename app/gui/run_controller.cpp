#include "app/gui/run_controller.h"

#include "app/gui/live_robot.h"
#include "drivers/paced_source.h"

namespace handmap {

namespace {
constexpr double kAtOnce = 0.0;
}

std::shared_ptr<const RunResult> RunController::result() const {
  return worker_ ? worker_->result() : last_result_;
}

void RunController::start(const Map& drawing, const Robot& robot, const RunSetup& setup,
                          Begin begin) {
  Q_ASSERT(!isActive());
  drawing_ = drawing;
  last_result_ = nullptr;
  live_ = robot.live;
  if (live_) live_->begin();
  ++number_;
  pace_ = std::make_shared<Pace>(begin == Begin::Running ? speed_ : kAtOnce);
  RunJob job;
  job.drawing = drawing;
  job.settings = setup.settings;
  job.open =
      [connect = robot.connect, replay = setup.replay, pace = pace_, is_live = live_ != nullptr](
          std::stop_token stop,
          const std::function<void(double)>& progress) -> std::unique_ptr<ObservationSource> {
    auto source = connect(replay, stop, progress);
    if (!source || is_live) return source;
    return std::make_unique<PacedSource>(std::move(source), pace, std::move(stop));
  };
  worker_ = std::make_unique<RunWorker>(std::move(job));
  listenTo(*worker_);
  if (begin == Begin::WithOneStep) worker_->step();
  worker_->start();
  setState(RunState::Running);
}

void RunController::listenTo(RunWorker& worker) {
  connect(&worker.mailbox(), &RunMailbox::arrived, this, [this](const RunNews& news) {
    if (live_) live_->tell(news.newest);
    Q_EMIT newsArrived(news);
  });
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
    end();
    Q_EMIT finished(cancelled);
  });
  connect(&worker, &RunWorker::failed, this, [this](const RunFailure& failure) {
    end();
    Q_EMIT failed(failure);
  });
}

void RunController::end() {
  last_result_ = worker_->result();
  letGo();
  setState(RunState::Idle);
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

void RunController::stop() {
  if (!worker_) return;
  const bool may_finish = live_ && state_ != RunState::Stopping;
  if (may_finish) {
    live_->monitor()->end();
    worker_->resume();
  } else {
    worker_->cancel();
  }
  setState(RunState::Stopping);
}

void RunController::discard() {
  letGo();
  ++number_;
  last_result_ = nullptr;
  live_ = nullptr;
  drawing_ = {};
  setState(RunState::Idle);
}

void RunController::setSpeed(double speed) {
  speed_ = speed;
  if (pace_ && state_ == RunState::Running) pace_->setSpeed(speed_);
}

void RunController::setState(RunState state) {
  if (state == state_) return;
  state_ = state;
  Q_EMIT stateChanged(state_);
}

}  // namespace handmap
