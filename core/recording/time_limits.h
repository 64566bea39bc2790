// What time stamps of files may be.
#pragma once

namespace handmap {

inline constexpr double kMaxTime_s = 1e12;  ///< of any epoch, either sign

}  // namespace handmap
