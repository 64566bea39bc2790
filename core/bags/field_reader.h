// Fields out of bytes from outside: those of ROS 1 (little-endian, without padding; the records of
// bags and MCAP are like them) and of CDR (ROS 2: aligned, either order of bytes).
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace handmap {

/// Gives nothing that is not there: throws BadInput "SOURCE: byte 12: found …" at the end.
class FieldReader {
 public:
  /// As ROS 1 writes. `bytes` must outlive it; `source` names them in messages.
  FieldReader(std::string_view bytes, std::string source)
      : bytes_(bytes), source_(std::move(source)) {}
  /// As CDR says in its first four bytes. Throws BadInput for what is no plain CDR.
  static FieldReader cdr(std::string_view bytes, std::string source);

  template <typename Number>
  Number get() {
    if (is_cdr_) align(sizeof(Number));
    char raw[sizeof(Number)];
    const std::string_view found = take(sizeof(Number));
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      raw[is_big_ ? sizeof(Number) - 1 - i : i] = found[i];
    }
    Number value;
    std::memcpy(&value, raw, sizeof(Number));
    return value;
  }
  /// A number that can be one: neither infinite nor NaN, at most `most` in size.
  double finite(double most);
  /// Seconds and nanoseconds, of ROS 1 and 2.
  double stamp();
  /// Seconds of nanoseconds in 64 bits.
  double nanoseconds() { return static_cast<double>(get<std::uint64_t>()) * 1e-9; }
  std::string text(std::size_t most_bytes = 4096);
  /// How many items follow, of at least `bytes_each`: no more than there is room for.
  std::size_t count(std::size_t bytes_each);
  std::string_view take(std::size_t bytes);
  /// Numbers of so many bytes each, as they lie in memory (little-endian).
  std::string numbers(std::size_t items, std::size_t bytes_each);
  /// A length in Length and as many bytes.
  template <typename Length>
  std::string_view takeSized() {
    return take(static_cast<std::size_t>(get<Length>()));
  }
  std::size_t left() const { return bytes_.size() - at_; }
  std::size_t at() const { return at_; }
  const std::string& source() const { return source_; }
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

 private:
  void align(std::size_t size);

  static_assert(std::endian::native == std::endian::little);
  std::string_view bytes_;
  std::string source_;
  std::size_t at_ = 0;
  std::size_t origin_ = 0;  ///< what CDR aligns to
  bool is_cdr_ = false;
  bool is_big_ = false;
  std::size_t widest_ = 8;  ///< no wider alignment
};

}  // namespace handmap
