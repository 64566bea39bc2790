// The cable between a device and who listens to it, as faults have it.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "drivers/device/q_phrase.h"
#include "drivers/virtual/faults.h"

namespace handmap {

template <typename Datum>
class FaultLine {
 public:
  using Emit = std::function<void(double time_s, const Datum&)>;
  using Tell = std::function<void(DeviceState, const QString&)>;

  FaultLine(std::vector<Fault> faults, DeviceRole role, RigClock clock, Emit emit, Tell tell)
      : faults_(std::move(faults)),
        role_(role),
        clock_(std::move(clock)),
        emit_(std::move(emit)),
        tell_(std::move(tell)) {
    QObject::connect(&watching_, &QTimer::timeout, &watching_, [this] { watchPlug(); });
  }

  void open() {
    tell_(DeviceState::Ready, {});
    watching_.start(kWatch_ms);
  }
  void close() {
    watching_.stop();
    tell_(DeviceState::Closed, {});
  }

  void pass(double time_s, const Datum& datum) {
    const auto fault = faultAt(faults_, role_, clock_());
    if (fault != FaultKind::Freeze) frozen_.reset();
    if (!fault) return emit_(time_s, datum);
    switch (*fault) {
      case FaultKind::Drop:
        if (++passed_ % 2 == 0) emit_(time_s, datum);
        return;
      case FaultKind::Late:
        QTimer::singleShot(kLate_ms, &watching_, [this, time_s, datum] { emit_(time_s, datum); });
        return;
      case FaultKind::Unplug:
        return;
      case FaultKind::Freeze:
        if (!frozen_) frozen_ = datum;
        return emit_(time_s, *frozen_);
      case FaultKind::Clock:
        return emit_(time_s + kOff_s, datum);
      default:
        return emit_(time_s, datum);  // not of a datum
    }
  }

 private:
  static constexpr int kWatch_ms = 20;
  static constexpr int kLate_ms = 3000;
  static constexpr double kOff_s = 3600.0;

  void watchPlug() {
    const bool gone = faultAt(faults_, role_, clock_()) == FaultKind::Unplug;
    if (gone == gone_) return;
    gone_ = gone;
    if (gone) {
      tell_(DeviceState::Lost, qPhrase("unplugged"));
    } else {
      tell_(DeviceState::Ready, {});
    }
  }

  std::vector<Fault> faults_;
  DeviceRole role_;
  RigClock clock_;
  Emit emit_;
  Tell tell_;
  QTimer watching_;
  std::optional<Datum> frozen_;
  int passed_ = 0;
  bool gone_ = false;
};

}  // namespace handmap
