// Waiting for what an event loop brings.
#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "drivers/device/device.h"

namespace handmap::test {

/// Whether it came to hold; the time-out is for machines that are busy, not for what is tested.
inline bool waitUntil(const std::function<bool()>& holds, int timeout_ms = 30000) {
  QElapsedTimer clock;
  clock.start();
  while (!holds() && clock.elapsed() < timeout_ms) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  return holds();
}

/// Lets the event loop go on for so long.
inline void pass(int milliseconds) {
  waitUntil([] { return false; }, milliseconds);
}

/// What a device said of itself.
struct StateLog {
  explicit StateLog(Device& device) {
    QObject::connect(&device, &Device::stateChanged, &context,
                     [this](DeviceState state, const QString& detail) {
                       states.push_back(state);
                       details.push_back(detail.toStdString());
                     });
  }
  bool is(DeviceState state) const { return !states.empty() && states.back() == state; }
  bool was(DeviceState state) const {
    return std::find(states.begin(), states.end(), state) != states.end();
  }

  QObject context;
  std::vector<DeviceState> states;
  std::vector<std::string> details;
};

}  // namespace handmap::test
