// What all fuzz targets share: a file in memory, and what may come of reading it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>
#include <opencv2/core/utility.hpp>
#include <sys/mman.h>
#include <unistd.h>

#include "core/base/error.h"

namespace handmap::fuzz {

/// A file that is nowhere on disk, for readers that take a path.
class File {
 public:
  explicit File(std::string_view content) : descriptor_(memfd_create("fuzz", 0)) {
    if (descriptor_ < 0) std::abort();
    const ssize_t written = write(descriptor_, content.data(), content.size());
    if (written != static_cast<ssize_t>(content.size())) std::abort();
  }
  ~File() { close(descriptor_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  std::filesystem::path path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

 private:
  int descriptor_;
};

/// Whatever is read, it is taken or refused as bad input, with a word; all else ends the program.
template <typename Read>
int takenOrRefused(Read read) {
  try {
    cv::setNumThreads(1);  // threads cost more than they do for so little
    read();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::BadInput || *error.what() == '\0') std::abort();
  }
  return 0;
}

/// What holds of everything that was read.
inline void require(bool holds) {
  if (!holds) std::abort();
}

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace handmap::fuzz
