// Memory for many short rows that are all released at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace handmap {

class RowMemory {
 public:
  /// Uninitialized; valid until release().
  std::uint32_t* take(std::size_t count) {
    if (chunk_ < chunks_.size() && used_ + count > kChunk) {
      ++chunk_;
      used_ = 0;
    }
    if (chunk_ == chunks_.size()) chunks_.emplace_back(new std::uint32_t[kChunk]);
    used_ += count;
    return chunks_[chunk_].get() + used_ - count;
  }
  /// Gives back what was taken last.
  void giveBack(std::size_t count) { used_ -= count; }
  /// The memory is kept for the next rows.
  void release() { chunk_ = used_ = 0; }

  static constexpr std::size_t kChunk = std::size_t{1} << 16;

 private:
  std::vector<std::unique_ptr<std::uint32_t[]>> chunks_;
  std::size_t chunk_ = 0;
  std::size_t used_ = 0;
};

}  // namespace handmap
