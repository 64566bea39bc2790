#include "widgets/rig/rig_trial.h"

#include "core/base/error.h"

namespace handmap {

RigTrial::RigTrial(QObject* parent)
    : QObject(parent), self_(std::make_shared<Lifeline<RigTrial>>(*this)) {}

RigTrial::~RigTrial() {
  self_->cut();
  stop();
}

void RigTrial::start(const Rig& rig, const RigAccess& access) {
  stop();
  monitor_ = std::make_shared<RigMonitor>();
  startInBackground([self = self_, rig, host = access.host, monitor = monitor_] {
    const auto tell = [&self](const Failure& failure) {
      self->post([failure](RigTrial& trial) { Q_EMIT trial.failed(failure); });
    };
    try {
      host(rig, monitor, {}, [&monitor](const Observation&) { monitor->given(); });
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
