#include "app/gui/rig/rig_trial.h"

#include "core/base/error.h"
#include "drivers/live/rig_host.h"

namespace handmap {

namespace {

/// Until the drive is ended.
void host(const Rig& rig, const MakeDevices& make, const std::shared_ptr<RigMonitor>& monitor) {
  RigHost host(rig, make, monitor);
  while (host.next({})) monitor->given();
}

}  // namespace

RigTrial::RigTrial(QObject* parent)
    : QObject(parent), self_(std::make_shared<Lifeline<RigTrial>>(*this)) {}

RigTrial::~RigTrial() {
  self_->cut();
  stop();
}

void RigTrial::start(const Rig& rig, const MakeDevices& make) {
  stop();
  monitor_ = std::make_shared<RigMonitor>();
  startInBackground([self = self_, rig, make, monitor = monitor_] {
    const auto tell = [&self](const Failure& failure) {
      self->post([failure](RigTrial& trial) { Q_EMIT trial.failed(failure); });
    };
    try {
      host(rig, make, monitor);
    } catch (const Error& error) {
      tell(failureOf(error));
    } catch (const std::exception& error) {
      tell({ErrorCode::RunFailed, QString::fromUtf8(error.what()), {}});
    }
  });
}

void RigTrial::stop() {
  if (monitor_) monitor_->end();
}

}  // namespace handmap
