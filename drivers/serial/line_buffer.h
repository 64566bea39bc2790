// Lines out of bytes that come in pieces.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace handmap {

/// Ended by LF, CR or both. A line longer than the limit is dropped whole and counted, so that
/// noise cannot fill the memory. Empty lines are told where `keeps_empty`, for protocols that end
/// an answer by one (LF alone ends a line then).
class LineBuffer {
 public:
  explicit LineBuffer(std::size_t longest, bool keeps_empty = false)
      : longest_(longest), keeps_empty_(keeps_empty) {}

  /// Calls `take(std::string_view)` for each line that is whole.
  template <typename Take>
  void feed(std::string_view bytes, Take take) {
    for (const char byte : bytes) {
      if (byte == '\n' || (byte == '\r' && !keeps_empty_)) {
        if (!too_long_ && (keeps_empty_ || !line_.empty())) take(std::string_view(line_));
        if (too_long_) ++dropped_;
        clear();
      } else if (line_.size() == longest_) {
        too_long_ = true;
      } else {
        line_ += byte;
      }
    }
  }
  void clear() {
    line_.clear();
    too_long_ = false;
  }
  int dropped() const { return dropped_; }

 private:
  std::size_t longest_;
  bool keeps_empty_;
  std::string line_;
  bool too_long_ = false;
  int dropped_ = 0;
};

}  // namespace handmap
