#include "core/bags/field_reader.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

FieldReader FieldReader::cdr(std::string_view bytes, std::string source) {
  FieldReader reader(bytes, std::move(source));
  const std::string_view header = reader.take(4);
  const auto kind = static_cast<unsigned char>(header[1]);
  const bool is_first = kind <= 1;                // XCDR1: CDR_BE, CDR_LE
  const bool is_second = kind == 6 || kind == 7;  // XCDR2: the same, aligned to 4 at most
  if (header[0] != 0 || (!is_first && !is_second)) {
    reader.fail(phrase("representation {}", kind), phrase("plain CDR"));
  }
  reader.is_cdr_ = true;
  reader.is_big_ = kind % 2 == 0;
  reader.widest_ = is_first ? 8 : 4;
  reader.origin_ = reader.at_;
  return reader;
}

void FieldReader::align(std::size_t size) {
  const std::size_t step = std::min(size, widest_);
  const std::size_t over = (at_ - origin_) % step;
  if (over > 0) take(step - over);
}

std::string_view FieldReader::take(std::size_t bytes) {
  if (bytes > left()) fail(phrase("{} bytes", left()), phrase("{} bytes", bytes));
  const std::string_view taken = bytes_.substr(at_, bytes);
  at_ += bytes;
  return taken;
}

std::string FieldReader::numbers(std::size_t items, std::size_t bytes_each) {
  if (items == 0) return {};
  if (is_cdr_) align(bytes_each);
  if (items > left() / bytes_each) {
    fail(phrase("{} bytes", left()), phrase("{} × {} bytes", items, bytes_each));
  }
  std::string raw(take(items * bytes_each));
  if (!is_big_) return raw;
  for (auto number = raw.begin(); number != raw.end();
       number += static_cast<std::ptrdiff_t>(bytes_each)) {
    std::reverse(number, number + static_cast<std::ptrdiff_t>(bytes_each));
  }
  return raw;
}

double FieldReader::finite(double most) {
  const auto value = get<double>();
  if (!std::isfinite(value) || std::abs(value) > most) {
    fail(formatNumber(value), phrase("a finite number, at most {}", formatNumber(most)));
  }
  return value;
}

double FieldReader::stamp() {
  const auto seconds = get<std::uint32_t>();
  return static_cast<double>(seconds) + 1e-9 * static_cast<double>(get<std::uint32_t>());
}

std::string FieldReader::text(std::size_t most_bytes) {
  const auto length = static_cast<std::size_t>(get<std::uint32_t>());
  if (length > most_bytes) fail(phrase("{} bytes", length), phrase("at most {} bytes", most_bytes));
  std::string_view taken = take(length);
  if (is_cdr_ && taken.ends_with('\0')) taken.remove_suffix(1);
  return std::string(taken);
}

std::size_t FieldReader::count(std::size_t bytes_each) {
  const auto items = static_cast<std::size_t>(get<std::uint32_t>());
  if (items > left() / bytes_each) {
    fail(phrase("{} bytes", left()), phrase("{} × {} bytes", items, bytes_each));
  }
  return items;
}

void FieldReader::fail(const std::string& found, const std::string& expected) const {
  throwBadInput(source_, phrase("byte {}", at_), found, expected);
}

}  // namespace handmap
