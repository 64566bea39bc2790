// The way of a snapshot from the worker to the screen: latest wins, one pending flag, so that a
// slow painter never builds up a queue and a fast worker never floods the event loop.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "core/method/snapshot.h"
#include "widgets/background/background.h"

namespace handmap {

/// What has come since the last look.
struct RunNews {
  std::shared_ptr<const Snapshot> newest;
  std::vector<FrameReport> reports;  ///< of every snapshot since, none left out: for the charts
};

class RunMailbox : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RunMailbox)
 public:
  /// Makes what is to be shown of a snapshot; called in a thread of its own.
  using Prepare = std::function<void(const Snapshot&)>;

  explicit RunMailbox(QObject* parent = nullptr);
  ~RunMailbox() override;

  /// What comes from now on is prepared before it is delivered.
  void setPrepare(Prepare prepare) { prepare_ = std::move(prepare); }
  /// From any thread; never waits.
  void post(std::shared_ptr<const Snapshot> snapshot);
  /// Delivers what is there now, prepared or not, e.g. because a run has ended. In this object's
  /// thread.
  void flush();

 Q_SIGNALS:
  /// In this object's thread, at most once in 16 ms.
  void arrived(const handmap::RunNews& news);

 private:
  void prepare();
  void deliver();
  RunNews taken();

  std::mutex mutex_;
  RunNews news_;
  bool pending_ = false;  ///< a delivery is on its way
  RunNews next_;          ///< that is being prepared
  Prepare prepare_;
  QTimer timer_;
  std::shared_ptr<Lifeline<RunMailbox>> lifeline_;
};

}  // namespace handmap
