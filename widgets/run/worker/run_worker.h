// A run in a thread of its own. Everything it has to say comes as signals in the thread of this
// object (the GUI thread) or through the mailbox. Nothing here waits for the run: a worker that is
// destroyed requests the stop and is silent at once; its thread ends by itself. The source that it
// reads is the feed's, and stays open for who goes on with it.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <stop_token>

#include "core/session/run_history.h"
#include "core/session/run_session.h"
#include "widgets/background/failure.h"
#include "widgets/run/worker/run_feed.h"
#include "widgets/run/worker/run_mailbox.h"

namespace handmap {

/// Copies of all that a run needs; it never looks back at the document.
struct RunJob {
  Map drawing;
  RunSettings settings;
  std::shared_ptr<RunFeed> feed;  ///< gone over from its beginning, if another run has used it
  int until = 0;  ///< observations to work in before it pauses for the first time; 0: it does not
};

/// What a run has found out after its latest whole step.
struct RunResult {
  explicit RunResult(std::shared_ptr<const Snapshot> snapshot) : last(std::move(snapshot)) {}

  std::shared_ptr<const Snapshot> last;
  const Map& map() const { return *last->map; }  ///< refined, ready to be saved
  std::vector<RunWarning> warnings;              ///< once the source is at its end
  std::string report;                            ///< the same; FORMATS 3
};

class RunWorker : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RunWorker)
 public:
  explicit RunWorker(RunJob job, QObject* parent = nullptr);
  ~RunWorker() override;

  /// Once, after the signals are connected. After pause() or step() it begins so.
  void start();

  RunMailbox& mailbox() { return mailbox_; }
  /// nullptr before the first step is done.
  std::shared_ptr<const RunResult> result() const;
  const std::shared_ptr<RunHistory>& history() const { return history_; }

 public Q_SLOTS:
  /// Each takes effect inside a step too: a paused step stands still until it is resumed.
  void pause();
  void resume();
  /// Works on until the end of the next step, then pauses.
  void step();
  /// The same; its snapshot tells the phases of the step.
  void stepPhases();
  /// The same, until so many observations are worked in.
  void runUntil(int index);
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
  void failed(const handmap::Failure& failure);

 private:
  class Thread;

  RunMailbox mailbox_;
  std::stop_source stop_;
  std::shared_ptr<RunHistory> history_;
  std::shared_ptr<Thread> thread_;  ///< shared with the thread, which may outlive this object
};

}  // namespace handmap
