#include "core/base/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handmap {

RandomStream::RandomStream(std::uint64_t seed, std::uint32_t a, std::uint32_t b, std::uint32_t c)
    : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
      counter_{{0, a, b, c}},
      block_{} {}

RandomStream::result_type RandomStream::operator()() {
  if (used_ == 4) {
    block_ = r123::Philox4x32()(counter_, key_);
    ++counter_[0];
    used_ = 0;
  }
  return block_[static_cast<std::size_t>(used_++)];
}

double RandomStream::uniform() { return (*this)() * 0x1p-32; }

void RandomStream::uniforms(std::span<float> values) {
  used_ = 4;  // what is left of the block before is not used
  const auto part = [](std::uint32_t bits) {
    return static_cast<float>(bits & 0xFFFFU) * 0x1p-16F;
  };
  for (; !values.empty(); ++counter_[0]) {
    const auto block = r123::Philox4x32()(counter_, key_);
    std::array<float, 8> numbers;
    for (std::size_t i = 0; i < 4; ++i) {
      numbers[i] = part(block[i]);
      numbers[i + 4] = part(block[i] >> 16U);
    }
    const std::size_t count = std::min(numbers.size(), values.size());
    std::copy_n(numbers.begin(), count, values.begin());
    values = values.subspan(count);
  }
}

double RandomStream::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  const double angle = 2.0 * std::numbers::pi * uniform();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

}  // namespace handmap
