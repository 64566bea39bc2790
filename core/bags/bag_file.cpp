#include "core/bags/bag_file.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/bags/packed.h"
#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

BagFile::BagFile(const std::filesystem::path& path)
    : name_(path.string()), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  struct stat status {};
  if (descriptor_ < 0 || fstat(descriptor_, &status) != 0) {
    throwBadInput(name_, "", fmt::format("\"{}\"", std::strerror(errno)),
                  phrase("a readable file"));
  }
  if (!S_ISREG(status.st_mode)) {
    close(descriptor_);
    throwBadInput(name_, "", phrase("no regular file"), phrase("a file"));
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

BagFile::~BagFile() { close(descriptor_); }

std::string BagFile::read(std::uint64_t offset, std::uint64_t bytes) const {
  if (!has(offset, bytes)) {
    throwBadInput(name_, phrase("byte {}", offset), phrase("the end of the file at {}", size_),
                  phrase("{} bytes", bytes));
  }
  if (bytes > kMostUnpackedBytes) {
    throwBadInput(name_, phrase("byte {}", offset), phrase("{} bytes", bytes),
                  phrase("at most {} bytes", kMostUnpackedBytes));
  }
  std::string content;
  content.resize(bytes);
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t count = pread(descriptor_, content.data() + done, content.size() - done,
                                static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      throwBadInput(name_, phrase("byte {}", offset),
                    count == 0 ? phrase("the end of the file at {}", offset + done)
                               : fmt::format("\"{}\"", std::strerror(errno)),
                    phrase("{} bytes", bytes));
    }
    done += static_cast<std::size_t>(count);
  }
  return content;
}

}  // namespace handmap
