// What of a Gaussian has no closed form.
#pragma once

namespace handmap {

inline constexpr double kMedianToSigma = 1.4826;   ///< σ over the median of how far it is off
inline constexpr double kQuarterToSigma = 3.1383;  ///< σ over what a quarter is off at most
inline constexpr double kWithinSigma = 0.6827;     ///< the share within one σ
/// χ² of three, beyond which one in a thousand is.
inline constexpr double kRareSquareOfThree = 16.3;

}  // namespace handmap
