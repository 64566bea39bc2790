// Fields as FieldReader reads them: as ROS 1 writes (and the records of MCAP), or as little-endian
// CDR.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace handmap {

class FieldWriter {
 public:
  /// Without padding.
  FieldWriter() = default;
  static FieldWriter cdr() {
    FieldWriter writer;
    writer.bytes_.assign("\0\1\0\0", kCdrHead);
    writer.is_cdr_ = true;
    return writer;
  }

  template <typename Number>
  void put(Number value) {
    if (is_cdr_) {
      const std::size_t over = (bytes_.size() - kCdrHead) % sizeof(Number);
      if (over > 0) bytes_.append(sizeof(Number) - over, '\0');
    }
    char raw[sizeof(Number)];
    std::memcpy(raw, &value, sizeof(Number));
    bytes_.append(raw, sizeof(Number));
  }
  void count(std::size_t items) { put(static_cast<std::uint32_t>(items)); }
  /// Of CDR it ends with a zero.
  void text(std::string_view text) {
    count(text.size() + (is_cdr_ ? 1 : 0));
    bytes_ += text;
    if (is_cdr_) bytes_ += '\0';
  }
  /// Seconds and nanoseconds.
  void stamp(double time_s) {
    const auto nanoseconds = static_cast<std::uint64_t>(std::llround(time_s * 1e9));
    put(static_cast<std::uint32_t>(nanoseconds / 1'000'000'000U));
    put(static_cast<std::uint32_t>(nanoseconds % 1'000'000'000U));
  }
  void raw(std::string_view bytes) { bytes_ += bytes; }
  /// How many bytes follow, and they.
  template <typename Length>
  void sized(std::string_view bytes) {
    put(static_cast<Length>(bytes.size()));
    raw(bytes);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  static constexpr std::size_t kCdrHead = 4;
  std::string bytes_;
  bool is_cdr_ = false;
};

}  // namespace handmap
