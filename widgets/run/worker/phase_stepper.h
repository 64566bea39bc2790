// Goes through the phases of one observation, one at a time.
#pragma once

#include <QObject>
#include <memory>

#include "core/method/phase.h"

namespace handmap {

class PhaseStepper : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// At the first phase of that; one without phases is shown whole.
  void begin(std::shared_ptr<const Snapshot> snapshot);
  /// After the last phase the whole is shown, and it is no longer active.
  void next();
  void leave();
  bool isActive() const { return snapshot_ != nullptr; }

 Q_SIGNALS:
  void shown(const handmap::Phase& phase, int number, int count);
  void ended(const std::shared_ptr<const handmap::Snapshot>& whole);

 private:
  void show();

  std::shared_ptr<const Snapshot> snapshot_;  ///< whose phases they are
  std::size_t at_ = 0;
};

}  // namespace handmap
