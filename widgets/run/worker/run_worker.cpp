#include "widgets/run/worker/run_worker.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>

#include "widgets/background/background.h"

namespace handmap {

namespace {
constexpr auto kProgressInterval = std::chrono::milliseconds(40);
}

/// What the thread of the run owns.
class RunWorker::Thread {
 public:
  enum class Command { Run, Pause, Step, StepPhases };

  Thread(RunJob job, RunWorker& worker)
      : job_(std::move(job)), worker_(worker), until_(job_.until) {}

  void letGo() { worker_.cut(); }
  void give(Command command, int until = 0);
  const std::shared_ptr<RunHistory>& history() const { return history_; }
  std::shared_ptr<const RunResult> result() const;
  void work(const std::stop_token& stop);

 private:
  bool run(const std::stop_token& stop);
  bool mayGoOn(const std::stop_token& stop);
  bool isTracing() const;
  void tellProgress(double share);
  void stepDone(std::shared_ptr<const Snapshot> snapshot);
  void conclude(const RunSession& session);
  void reportSkipped(const RunSession& session);
  void tellFailure(const Failure& failure);

  RunJob job_;
  Lifeline<RunWorker> worker_;
  mutable std::mutex mutex_;
  std::condition_variable_any given_;
  Command command_ = Command::Run;           // under mutex_
  bool stands_still_ = false;                // under mutex_: paused() was the last that was said
  int until_;                                // under mutex_: pauses there; 0: nowhere
  std::shared_ptr<const RunResult> result_;  // under mutex_
  std::shared_ptr<RunHistory> history_ = std::make_shared<RunHistory>();
  std::atomic<std::chrono::steady_clock::time_point> progress_told_{};
  std::size_t skipped_reported_ = 0;
};

void RunWorker::Thread::give(Command command, int until) {
  {
    const std::scoped_lock lock(mutex_);
    command_ = command;
    until_ = until;
  }
  given_.notify_all();
}

std::shared_ptr<const RunResult> RunWorker::Thread::result() const {
  const std::scoped_lock lock(mutex_);
  return result_;
}

bool RunWorker::Thread::isTracing() const {
  const std::scoped_lock lock(mutex_);
  return command_ == Command::StepPhases;
}

// A step calls this from several threads. What is said is queued, so saying it under the mutex
// costs nothing and keeps it in order.
bool RunWorker::Thread::mayGoOn(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (command_ == Command::Pause && !stop.stop_requested()) {
    if (!std::exchange(stands_still_, true)) {
      worker_.post([](RunWorker& worker) { Q_EMIT worker.paused(); });
    }
    given_.wait(lock, stop, [this] { return command_ != Command::Pause || !stands_still_; });
  }
  if (stop.stop_requested()) return false;
  if (std::exchange(stands_still_, false)) {
    worker_.post([](RunWorker& worker) { Q_EMIT worker.resumed(); });
  }
  return true;
}

void RunWorker::Thread::tellProgress(double share) {
  const auto now = std::chrono::steady_clock::now();
  auto told = progress_told_.load();
  if (now - told >= kProgressInterval && progress_told_.compare_exchange_strong(told, now)) {
    worker_.post([share](RunWorker& worker) { Q_EMIT worker.progressed(share); });
  }
}

void RunWorker::Thread::stepDone(std::shared_ptr<const Snapshot> snapshot) {
  auto result = std::make_shared<const RunResult>(snapshot);
  history_->add(*snapshot);
  {
    const std::scoped_lock lock(mutex_);
    result_ = std::move(result);
    const bool arrived = until_ > 0 && snapshot->index >= until_;
    if (arrived) until_ = 0;
    const bool stepped =
        command_ == Command::Step || (command_ == Command::StepPhases && result_->last->phases);
    if (stepped || (arrived && command_ == Command::Run)) {
      command_ = Command::Pause;
    }
  }
  worker_.with([&](RunWorker& worker) { worker.mailbox_.post(std::move(snapshot)); });
}

void RunWorker::Thread::conclude(const RunSession& session) {
  auto result = std::make_shared<RunResult>(this->result()->last);
  result->warnings = session.warnings();
  result->report = session.reportJson();
  const std::scoped_lock lock(mutex_);
  result_ = std::move(result);
}

void RunWorker::Thread::reportSkipped(const RunSession& session) {
  for (; skipped_reported_ < session.skipped().size(); ++skipped_reported_) {
    const SkippedFrame& skipped = session.skipped()[skipped_reported_];
    worker_.post([frame = skipped.frame, reason = QString::fromStdString(skipped.reason)](
                     RunWorker& worker) { Q_EMIT worker.frameSkipped(frame, reason); });
  }
}

/// True: the source is at its end.
bool RunWorker::Thread::run(const std::stop_token& stop) {
  auto tape = job_.feed->open([this](double share) { tellProgress(share); });
  if (!tape || stop.stop_requested()) return false;
  RunSession session(job_.drawing, std::move(tape), job_.settings);
  worker_.post([info = std::make_shared<const SourceInfo>(session.source())](RunWorker& worker) {
    Q_EMIT worker.started(info);
  });
  const auto progress = [this, &stop](double share) {
    if (mayGoOn(stop)) tellProgress(share);
  };
  while (mayGoOn(stop)) {
    session.setTracing(isTracing());
    auto snapshot = session.step(stop, progress);
    reportSkipped(session);
    if (!snapshot) {
      if (stop.stop_requested()) return false;
      conclude(session);
      return true;
    }
    stepDone(std::move(snapshot));
  }
  return false;
}

void RunWorker::Thread::tellFailure(const Failure& failure) {
  worker_.post([failure](RunWorker& worker) { Q_EMIT worker.failed(failure); });
}

void RunWorker::Thread::work(const std::stop_token& stop) {
  try {
    const bool at_end = run(stop);
    worker_.post([at_end](RunWorker& worker) { Q_EMIT worker.finished(!at_end); });
  } catch (const Error& error) {
    tellFailure(failureOf(error));
  } catch (const std::bad_alloc&) {
    tellFailure({ErrorCode::RunFailed, tr("The run needs more memory than there is."),
                 tr("A shorter stretch of the recording needs less, and by the published method "
                    "fewer particles.")});
  } catch (const std::exception& error) {
    tellFailure(
        {ErrorCode::RunFailed,
         tr("The run ended with an unexpected error: %1").arg(QString::fromUtf8(error.what())),
         {}});
  }
}

RunWorker::RunWorker(RunJob job, QObject* parent) : QObject(parent), mailbox_(this) {
  thread_ = std::make_shared<Thread>(std::move(job), *this);
  history_ = thread_->history();
  // Who hears that a run stands still or has ended has seen its last snapshot.
  connect(this, &RunWorker::paused, &mailbox_, &RunMailbox::flush);
  connect(this, &RunWorker::finished, &mailbox_, &RunMailbox::flush);
  connect(this, &RunWorker::failed, &mailbox_, &RunMailbox::flush);
}

RunWorker::~RunWorker() {
  thread_->letGo();
  cancel();
}

void RunWorker::start() {
  startInBackground([thread = thread_, stop = stop_.get_token()] { thread->work(stop); });
}

std::shared_ptr<const RunResult> RunWorker::result() const { return thread_->result(); }

void RunWorker::pause() { thread_->give(Thread::Command::Pause); }
void RunWorker::resume() { thread_->give(Thread::Command::Run); }
void RunWorker::step() { thread_->give(Thread::Command::Step); }
void RunWorker::stepPhases() { thread_->give(Thread::Command::StepPhases); }
void RunWorker::runUntil(int index) { thread_->give(Thread::Command::Run, index); }

void RunWorker::cancel() { stop_.request_stop(); }

}  // namespace handmap
