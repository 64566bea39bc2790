// Positive numbers by their size, four levels for each doubling: the index of a table over what
// spans orders of magnitude, without a logarithm.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace handmap {

/// Read off the bits of the number: its exponent and the first two of its fraction.
constexpr int quarterOctave(float value) {
  return static_cast<int>(std::bit_cast<std::uint32_t>(value) >> 21U);
}

/// The middle of the numbers of a level.
inline double middleOfQuarterOctave(int level) {
  return std::ldexp(1.0 + 0.25 * (level % 4 + 0.5), level / 4 - 127);
}

}  // namespace handmap
