#include <cstdint>

#include <zlib.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/logs/array.h"

namespace handmap {

namespace {

constexpr std::size_t kMostInflated = 512u << 20;
constexpr std::size_t kMostEntries = 1000;
constexpr std::uint32_t kLocal = 0x04034b50;
constexpr std::uint32_t kCentral = 0x02014b50;
constexpr std::uint32_t kEnd = 0x06054b50;
constexpr std::size_t kEndBytes = 22;
constexpr std::size_t kCentralBytes = 46;
constexpr std::size_t kLocalBytes = 30;
constexpr std::uint32_t kSizeIsElsewhere = 0xffffffff;  // ZIP64
constexpr std::size_t kMostComment = 65535;

class Zip {
 public:
  Zip(std::string_view content, std::string source)
      : content_(content), source_(std::move(source)) {}

  std::map<std::string, Array> arrays() {
    std::map<std::string, Array> arrays;
    const std::size_t end = endRecord();
    const std::size_t entries = number(end + 10, 2);
    if (entries > kMostEntries) fail(phrase("{} entries", entries));
    std::size_t at = number(end + 16, 4);
    for (std::size_t i = 0; i < entries; ++i) {
      if (number(at, 4) != kCentral) fail(phrase("a damaged directory"));
      const std::size_t name_bytes = number(at + 28, 2);
      std::string name(bytes(at + kCentralBytes, name_bytes));
      if (name.ends_with(".npy")) {
        name.resize(name.size() - 4);
        arrays[name] = parseNpy(inflated(at), source_ + ": " + name);
      }
      at += kCentralBytes + name_bytes + number(at + 30, 2) + number(at + 32, 2);
    }
    return arrays;
  }

 private:
  [[noreturn]] void fail(const std::string& found) const {
    throwBadInput(source_, "", found, phrase("a .npz as numpy saves it"));
  }

  std::string_view bytes(std::size_t at, std::size_t count) const {
    if (at > content_.size() || count > content_.size() - at)
      fail(phrase("a file that is cut off"));
    return content_.substr(at, count);
  }

  std::size_t number(std::size_t at, std::size_t count) const {
    std::size_t value = 0;
    const std::string_view raw = bytes(at, count);
    for (std::size_t i = count; i-- > 0;) value = value << 8U | static_cast<unsigned char>(raw[i]);
    return value;
  }

  /// It stands last, before a comment.
  std::size_t endRecord() const {
    if (content_.size() < kEndBytes) fail(phrase("{} bytes", content_.size()));
    const std::size_t last = content_.size() - kEndBytes;
    const std::size_t first = last > kMostComment ? last - kMostComment : 0;
    for (std::size_t at = last + 1; at-- > first;) {
      if (number(at, 4) == kEnd) return at;
    }
    fail(phrase("no directory"));
  }

  /// Of the field of ZIP64, in the order of the format, where 32 bits do not do.
  std::size_t longSize(std::size_t entry, std::size_t which) const {
    const std::size_t begin = entry + kCentralBytes + number(entry + 28, 2);
    const std::size_t end = begin + number(entry + 30, 2);
    for (std::size_t at = begin; at + 4 <= end; at += 4 + number(at + 2, 2)) {
      if (number(at, 2) == 1) return number(at + 4 + 8 * which, 8);
    }
    fail(phrase("an entry without its size"));
  }

  std::string inflated(std::size_t entry) {
    const std::size_t method = number(entry + 10, 2);
    std::size_t packed = number(entry + 20, 4);
    std::size_t whole = number(entry + 24, 4);
    const std::size_t local = number(entry + 42, 4);
    if (whole == kSizeIsElsewhere) whole = longSize(entry, 0);
    if (packed == kSizeIsElsewhere) packed = longSize(entry, 1);
    if (whole > kMostInflated - total_) fail(phrase("more than {} MB", kMostInflated >> 20U));
    total_ += whole;
    if (number(local, 4) != kLocal) fail(phrase("a damaged entry"));
    const std::size_t begin = local + kLocalBytes + number(local + 26, 2) + number(local + 28, 2);
    const std::string_view raw = bytes(begin, packed);
    if (method == 0) return std::string(raw);
    if (method != Z_DEFLATED) fail(phrase("packing method {}", method));
    return inflate(raw, whole);
  }

  std::string inflate(std::string_view raw, std::size_t whole) const {
    std::string out(whole, '\0');
    z_stream stream{};
    // The bytes are not written to: zlib's own type has no const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(raw.data()));
    stream.avail_in = static_cast<uInt>(raw.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) fail(phrase("no memory"));
    const int status = ::inflate(&stream, Z_FINISH);
    inflateEnd(&stream);
    if (status != Z_STREAM_END || stream.avail_out != 0) fail(phrase("damaged data"));
    return out;
  }

  std::string_view content_;
  std::string source_;
  std::size_t total_ = 0;
};

}  // namespace

std::map<std::string, Array> parseNpz(std::string_view content, const std::string& source) {
  return Zip(content, source).arrays();
}

}  // namespace handmap
