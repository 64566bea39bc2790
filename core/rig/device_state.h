// How a device of a rig is.
#pragma once

namespace handmap {

/// Degraded: it delivers, but not as it should; the detail says what is wrong.
enum class DeviceState { Closed, Connecting, Ready, Degraded, Lost };

}  // namespace handmap
