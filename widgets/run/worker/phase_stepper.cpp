#include "widgets/run/worker/phase_stepper.h"

#include <utility>

namespace handmap {

void PhaseStepper::begin(std::shared_ptr<const Snapshot> snapshot) {
  snapshot_ = std::move(snapshot);
  at_ = 0;
  show();
}

void PhaseStepper::next() {
  if (!snapshot_) return;
  ++at_;
  show();
}

void PhaseStepper::leave() { snapshot_.reset(); }

void PhaseStepper::show() {
  const auto& phases = snapshot_->phases;
  if (phases && at_ < phases->size()) {
    Q_EMIT shown((*phases)[at_], static_cast<int>(at_) + 1, static_cast<int>(phases->size()));
    return;
  }
  const auto whole = std::exchange(snapshot_, nullptr);
  Q_EMIT ended(whole);
}

}  // namespace handmap
