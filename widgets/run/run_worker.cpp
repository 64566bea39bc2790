#include "widgets/run/run_worker.h"

#include <new>

namespace handmap {

namespace {
constexpr auto kProgressInterval = std::chrono::milliseconds(40);
}

RunFailure failureOf(const Error& error) {
  return {error.code(), QString::fromStdString(error.what()), QString::fromStdString(error.hint())};
}

RunWorker::RunWorker(RunJob job, QObject* parent)
    : QObject(parent), job_(std::move(job)), mailbox_(this) {
  // Who hears that a run stands still or has ended has seen its last snapshot.
  connect(this, &RunWorker::paused, &mailbox_, &RunMailbox::flush);
  connect(this, &RunWorker::finished, &mailbox_, &RunMailbox::flush);
  connect(this, &RunWorker::failed, &mailbox_, &RunMailbox::flush);
}

void RunWorker::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

std::shared_ptr<const RunResult> RunWorker::result() const {
  const std::scoped_lock lock(mutex_);
  return result_;
}

void RunWorker::pause() { give(Command::Pause); }
void RunWorker::resume() { give(Command::Run); }
void RunWorker::step() { give(Command::Step); }
void RunWorker::cancel() { thread_.request_stop(); }

void RunWorker::give(Command command) {
  {
    const std::scoped_lock lock(mutex_);
    command_ = command;
  }
  given_.notify_all();
}

// A step calls this from several threads. The signals are queued, so saying them under the mutex
// costs nothing and keeps them in order.
bool RunWorker::mayGoOn(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (command_ == Command::Pause && !stop.stop_requested()) {
    if (!std::exchange(stands_still_, true)) Q_EMIT paused();
    given_.wait(lock, stop, [this] { return command_ != Command::Pause || !stands_still_; });
  }
  if (stop.stop_requested()) return false;
  if (std::exchange(stands_still_, false)) Q_EMIT resumed();
  return true;
}

void RunWorker::tellProgress(double share) {
  const auto now = std::chrono::steady_clock::now();
  auto told = progress_told_.load();
  if (now - told >= kProgressInterval && progress_told_.compare_exchange_strong(told, now)) {
    Q_EMIT progressed(share);
  }
}

void RunWorker::stepDone(const RunSession& session, std::shared_ptr<const Snapshot> snapshot) {
  auto result = std::make_shared<RunResult>();
  result->map = session.refinedMap();
  result->trajectory = snapshot->trajectory;
  {
    const std::scoped_lock lock(mutex_);
    result_ = std::move(result);
    if (command_ == Command::Step) command_ = Command::Pause;
  }
  mailbox_.post(std::move(snapshot));
}

void RunWorker::reportSkipped(const RunSession& session) {
  for (; skipped_reported_ < session.skipped().size(); ++skipped_reported_) {
    const SkippedFrame& skipped = session.skipped()[skipped_reported_];
    Q_EMIT frameSkipped(skipped.frame, QString::fromStdString(skipped.reason));
  }
}

void RunWorker::run(const std::stop_token& stop) {
  auto source = job_.open(stop, [this](double share) { tellProgress(share); });
  if (!source) {
    Q_EMIT finished(true);
    return;
  }
  RunSession session(job_.drawing, std::move(source), job_.settings);
  Q_EMIT started(std::make_shared<const SourceInfo>(session.source()));
  const auto progress = [this, &stop](double share) {
    if (mayGoOn(stop)) tellProgress(share);
  };
  bool at_end = false;
  while (!at_end && mayGoOn(stop)) {
    auto snapshot = session.step(stop, progress);
    reportSkipped(session);
    at_end = !snapshot && !stop.stop_requested();
    if (snapshot) stepDone(session, std::move(snapshot));
  }
  Q_EMIT finished(!at_end);
}

void RunWorker::work(const std::stop_token& stop) {
  RunFailure failure;
  try {
    run(stop);
    return;
  } catch (const Error& error) {
    failure = failureOf(error);
  } catch (const std::bad_alloc&) {
    failure.message = tr("The run needs more memory than there is.");
    failure.hint = tr("Fewer particles in the run settings need less.");
  } catch (const std::exception& error) {
    failure.message =
        tr("The run ended with an unexpected error: %1").arg(QString::fromUtf8(error.what()));
  }
  Q_EMIT failed(failure);
}

}  // namespace handmap
