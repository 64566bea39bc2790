// Injected randomness: counter-based streams (Salmon et al., "Parallel random numbers: as easy as
// 1, 2, 3", SC 2011), so that a result does not depend on the number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <Random123/philox.h>

namespace handmap {

/// One independent stream for each (seed, a, b, c), e.g. (seed, frame, particle, purpose).
/// A UniformRandomBitGenerator; the normal and uniform draws are ours because those of the standard
/// library are not specified to the bit.
class RandomStream {
 public:
  using result_type = std::uint32_t;

  explicit RandomStream(std::uint64_t seed, std::uint32_t a = 0, std::uint32_t b = 0,
                        std::uint32_t c = 0);

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  result_type operator()();
  /// In [0, 1), 32 random bits.
  double uniform();
  /// Fills `values` with numbers in [0, 1) of 16 random bits, eight from each block of the counter.
  void uniforms(std::span<float> values);
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Standard normal (Box-Muller; both values of a pair are used).
  double normal();
  double normal(double mean, double sigma) { return mean + sigma * normal(); }
  /// So many, the last drawn first. (Arguments of one call are drawn in the compiler's order.)
  template <std::size_t Count>
  std::array<double, Count> normals() {
    std::array<double, Count> drawn;
    for (std::size_t i = Count; i-- > 0;) drawn[i] = normal();
    return drawn;
  }
  /// In 0 … count - 1; count > 0.
  int index(int count) { return static_cast<int>(uniform() * count); }

 private:
  r123::Philox4x32::key_type key_;
  r123::Philox4x32::ctr_type counter_;
  r123::Philox4x32::ctr_type block_;
  int used_ = 4;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace handmap
