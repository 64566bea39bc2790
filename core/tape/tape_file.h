// Where a tape puts what no longer fits into memory: a file without a name, which goes with the
// program however that ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace handmap {

class TapeFile {
 public:
  struct Place {
    std::uint64_t begin = 0;
    std::uint64_t bytes = 0;
  };

  TapeFile() = default;
  ~TapeFile();
  TapeFile(const TapeFile&) = delete;
  TapeFile& operator=(const TapeFile&) = delete;

  /// nullopt where the disk is full or there is none to write to. One thread.
  std::optional<Place> add(std::span<const std::byte> bytes);
  /// From any thread. Empty where it cannot be read.
  std::vector<std::byte> read(const Place& place) const;
  /// Everything up to the end of it may go; the disk has the room again.
  void forget(const Place& place);

 private:
  bool open();

  int file_ = -1;
  std::uint64_t end_ = 0;
};

}  // namespace handmap
