// A rig that is tried without a run: its devices are opened, and what they see is looked at.
#pragma once

#include <QObject>
#include <memory>

#include "widgets/background/background.h"
#include "widgets/background/failure.h"
#include "widgets/rig/rig_access.h"

namespace handmap {

class RigTrial : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RigTrial)
 public:
  explicit RigTrial(QObject* parent = nullptr);
  ~RigTrial() override;

  /// Ends the one before; none of this waits.
  void start(const Rig& rig, const RigAccess& access);
  void stop();
  /// Of the latest trial; nullptr before the first.
  std::shared_ptr<RigMonitor> monitor() const { return monitor_; }

 Q_SIGNALS:
  void failed(const handmap::Failure& failure);

 private:
  std::shared_ptr<RigMonitor> monitor_;
  std::shared_ptr<Lifeline<RigTrial>> self_;  ///< shared with the threads
};

}  // namespace handmap
