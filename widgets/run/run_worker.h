// A run in a thread of its own. Everything it has to say comes as signals in the thread of this
// object (the GUI thread) or through the mailbox; nothing here waits for the run, but for the
// destructor: it cancels and waits for the step to give up, about as long as one stereo pair takes.
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>

#include "core/base/error.h"
#include "core/session/run_session.h"
#include "widgets/run/run_mailbox.h"

namespace handmap {

/// Copies of all that a run needs; it never looks back at the document.
struct RunJob {
  Map drawing;
  RunSettings settings;
  /// Called in the worker's thread: opening may take its time, and tells the share done. The source
  /// must not wait for anything once the stop is requested; nullptr when it was requested before
  /// the source was open. Throws handmap::Error.
  std::function<std::unique_ptr<ObservationSource>(std::stop_token,
                                                   const std::function<void(double)>&)>
      open;
};

struct RunFailure {
  ErrorCode code = ErrorCode::RunFailed;
  QString message;
  QString hint;
};

RunFailure failureOf(const Error& error);

/// What a run has found out after its latest whole step.
struct RunResult {
  Map map;  ///< refined, ready to be saved
  std::shared_ptr<const std::vector<StampedPose>> trajectory;
};

class RunWorker : public QObject {
  Q_OBJECT
 public:
  explicit RunWorker(RunJob job, QObject* parent = nullptr);

  /// Once, after the signals are connected. After pause() or step() it begins so.
  void start();

  RunMailbox& mailbox() { return mailbox_; }
  /// nullptr before the first step is done.
  std::shared_ptr<const RunResult> result() const;

 public Q_SLOTS:
  /// Each takes effect inside a step too: a paused step stands still until it is resumed.
  void pause();
  void resume();
  /// Works on until the end of the next step, then pauses.
  void step();
  void cancel();

 Q_SIGNALS:
  // State changes; none of them is ever lost.
  void started(const std::shared_ptr<const handmap::SourceInfo>& source);
  void paused();  ///< it stands still, maybe in the middle of a step
  void resumed();
  void frameSkipped(int frame, const QString& reason);
  void progressed(double share_of_step);
  /// The last one: the source is at its end, or the run was cancelled.
  void finished(bool cancelled);
  /// Or this one.
  void failed(const handmap::RunFailure& failure);

 private:
  enum class Command { Run, Pause, Step };

  void give(Command command);
  void work(const std::stop_token& stop);
  void run(const std::stop_token& stop);
  bool mayGoOn(const std::stop_token& stop);
  void tellProgress(double share);
  void stepDone(const RunSession& session, std::shared_ptr<const Snapshot> snapshot);
  void reportSkipped(const RunSession& session);

  RunJob job_;
  RunMailbox mailbox_;
  mutable std::mutex mutex_;
  std::condition_variable_any given_;
  Command command_ = Command::Run;           // under mutex_
  bool stands_still_ = false;                // under mutex_: paused() was the last that was said
  std::shared_ptr<const RunResult> result_;  // under mutex_
  std::atomic<std::chrono::steady_clock::time_point> progress_told_{};
  std::size_t skipped_reported_ = 0;  // of the worker's thread
  std::jthread thread_;               // last: ends before what it uses
};

}  // namespace handmap
