// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <cstddef>

namespace handmap::tape {

// Where a run may be done again: a scan of 360 rays takes 20 kB, ten a second.
inline constexpr std::size_t kMemory = std::size_t{16}
                                       << 20U;               // bytes; limit: a minute of a scanner
inline constexpr std::size_t kDisk = std::size_t{5} << 30U;  // bytes; limit: seven hours of one, or
                                                             // a quarter of one of a spinning lidar

}  // namespace handmap::tape
