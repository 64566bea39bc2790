// What a device said last of itself, so that it says nothing twice.
#pragma once

#include <QString>

#include "drivers/device/device.h"

namespace handmap {

/// What sends all the time and has not for so long is lost.
inline constexpr double kSilence_s = 1.0;

class ToldState {
 public:
  /// Whether there is something new to say; then it counts as said.
  bool changes(DeviceState state, const QString& detail) {
    if (state == state_ && detail == detail_) return false;
    state_ = state;
    detail_ = detail;
    return true;
  }
  DeviceState state() const { return state_; }

 private:
  DeviceState state_ = DeviceState::Closed;
  QString detail_;
};

}  // namespace handmap
