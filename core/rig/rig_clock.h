// The time that all devices of a rig share.
#pragma once

#include <chrono>
#include <functional>

namespace handmap {

/// Seconds since the rig began; never runs backwards.
using RigClock = std::function<double()>;

/// One that begins now.
inline RigClock startedRigClock() {
  using Clock = std::chrono::steady_clock;
  return [begin = Clock::now()] {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
}

}  // namespace handmap
