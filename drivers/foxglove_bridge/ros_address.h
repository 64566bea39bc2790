// The bridge that an address names: "ws://host:9090" a rosbridge, "foxglove://host:8765" one of
// Foxglove.
#pragma once

#include <memory>
#include <string>

#include "drivers/rosbridge/ros_client.h"

namespace handmap {

/// Throws BadInput for another address.
std::shared_ptr<RosClient> rosClientAt(const std::string& address, RosVersion version,
                                       std::uint64_t seed);

}  // namespace handmap
