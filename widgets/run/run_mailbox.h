// The way of a snapshot from the worker to the screen: latest wins, one pending flag, so that a
// slow painter never builds up a queue and a fast worker never floods the event loop.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <mutex>
#include <vector>

#include "core/session/snapshot.h"

namespace handmap {

/// What has come since the last look.
struct RunNews {
  std::shared_ptr<const Snapshot> newest;
  std::vector<FrameReport> reports;  ///< of every snapshot since, none left out: for the charts
};

class RunMailbox : public QObject {
  Q_OBJECT
 public:
  explicit RunMailbox(QObject* parent = nullptr);

  /// From any thread; never waits.
  void post(std::shared_ptr<const Snapshot> snapshot);
  /// Delivers what is there now, e.g. because a run has ended. In this object's thread.
  void flush();

 Q_SIGNALS:
  /// In this object's thread, at most once in 16 ms.
  void arrived(const handmap::RunNews& news);

 private:
  std::mutex mutex_;
  RunNews news_;
  bool pending_ = false;  ///< a delivery is on its way
  QTimer timer_;
};

}  // namespace handmap
