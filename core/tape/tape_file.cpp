#include "core/tape/tape_file.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace handmap {

namespace {

/// /tmp may be memory; /var/tmp is for what is large (file-hierarchy(7)).
std::vector<std::filesystem::path> folders() {
  std::vector<std::filesystem::path> all;
  if (const char* chosen = std::getenv("TMPDIR")) all.emplace_back(chosen);
  all.emplace_back("/var/tmp");
  std::error_code none;
  if (auto usual = std::filesystem::temp_directory_path(none); !none) {
    all.push_back(std::move(usual));
  }
  return all;
}

int openIn(const std::filesystem::path& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file >= 0) return file;
  std::string name = folder / "handmap-XXXXXX";  // where the file system knows no nameless files
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

}  // namespace

TapeFile::~TapeFile() {
  if (file_ >= 0) ::close(file_);
}

bool TapeFile::open() {
  if (file_ >= 0) return true;
  for (const std::filesystem::path& folder : folders()) {
    file_ = openIn(folder);
    if (file_ >= 0) return true;
  }
  return false;
}

std::optional<TapeFile::Place> TapeFile::add(std::span<const std::byte> bytes) {
  if (!open()) return std::nullopt;
  const Place place{end_, bytes.size()};
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(end_));
    if (written <= 0) {
      end_ = place.begin;
      return std::nullopt;
    }
    end_ += static_cast<std::uint64_t>(written);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return place;
}

std::vector<std::byte> TapeFile::read(const Place& place) const {
  std::vector<std::byte> bytes(place.bytes);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::pread(file_, bytes.data() + done, bytes.size() - done,
                                static_cast<off_t>(place.begin + done));
    if (got <= 0) return {};
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

void TapeFile::forget(const Place& place) {
  if (file_ < 0 || place.bytes == 0) return;
  // Where the file system cannot, the room comes back at the end.
  static_cast<void>(::fallocate(file_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, 0,
                                static_cast<off_t>(place.begin + place.bytes)));
}

}  // namespace handmap
