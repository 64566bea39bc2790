// Replacing a file as a whole (POSIX).
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxLinks = 40;  // as the kernel
constexpr mode_t kPermissions = 0777;
constexpr mode_t kOnlyMine = 0600;
constexpr mode_t kAsUsual = 0666;  // less the umask

[[noreturn]] void fail(const fs::path& path, int reason) {
  throw Error(ErrorCode::RunFailed,
              phrase("{}: cannot be written: {}", path.string(), std::strerror(reason)));
}

/// Where the links of `path` lead, whether or not there is a file: the link itself stays.
fs::path behindLinks(const fs::path& path) {
  fs::path target = path;
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    if (links == kMaxLinks) fail(path, ELOOP);
    target = target.parent_path() / fs::read_symlink(target, error);
    if (error) fail(path, error.value());
  }
  return target;
}

std::optional<struct stat> statusOf(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

/// An open file, closed whatever happens. Errors are told in the name of `path`.
class Descriptor {
 public:
  Descriptor(int descriptor, const fs::path& path) : descriptor_(descriptor), path_(path) {
    if (descriptor < 0) fail(path, errno);
  }
  ~Descriptor() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return descriptor_; }

  void write(std::string_view content) const {
    while (!content.empty()) {
      const ssize_t count = ::write(descriptor_, content.data(), content.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(path_, errno);
      content.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  void sync() const {
    const bool done = fsync(descriptor_) == 0 || errno == EINVAL || errno == ENOTSUP;
    if (!done) fail(path_, errno);
  }

  /// Some file systems tell of a full disk only here.
  void finish() {
    if (close(std::exchange(descriptor_, -1)) != 0) fail(path_, errno);
  }

 private:
  int descriptor_;
  const fs::path& path_;
};

/// A new file beside the target, gone again unless it takes its place.
class Part {
 public:
  Part(const fs::path& folder, mode_t mode) {
    static std::atomic<unsigned> counter = 0;
    do {  // a name may be left over from a process that was killed
      path_ = folder / fmt::format(".handmap-{}-{}.part", getpid(), counter++);
      descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    } while (descriptor_ < 0 && errno == EEXIST);
    pending_ = descriptor_ >= 0;
  }
  ~Part() {
    if (pending_) unlink(path_.c_str());
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  int descriptor() const { return descriptor_; }
  bool replace(const fs::path& target) {
    pending_ = rename(path_.c_str(), target.c_str()) != 0;
    return !pending_;
  }

 private:
  fs::path path_;
  int descriptor_ = -1;
  bool pending_ = false;
};

/// The owner as far as this user may give files away.
void takeOver(int descriptor, const struct stat& from) {
  if (fchown(descriptor, from.st_uid, from.st_gid) != 0) {
    [[maybe_unused]] const int ignored = fchown(descriptor, uid_t(-1), from.st_gid);
  }
  [[maybe_unused]] const int ignored = fchmod(descriptor, from.st_mode & kPermissions);
}

/// The new name is on disk, too. The file is whole in any case: no word where that cannot be had.
void syncFolder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

void replaceFile(const fs::path& path, std::string_view content) {
  const fs::path target = behindLinks(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const auto before = statusOf(target);
  if (before && access(target.c_str(), W_OK) != 0) fail(path, errno);
  Part part(folder, before ? kOnlyMine : kAsUsual);  // what was private is so from the start
  Descriptor file(part.descriptor(), path);
  if (before) takeOver(file.number(), *before);
  file.write(content);
  file.sync();
  file.finish();
  if (!part.replace(target)) fail(path, errno);
  syncFolder(folder);
}

}  // namespace

void writeFileAtomically(const fs::path& path, std::string_view content) {
  const auto status = statusOf(path);
  if (!status || S_ISREG(status->st_mode)) return replaceFile(path, content);
  // A pipe or a device (/dev/stdout, /dev/null) takes the bytes and stays what it is.
  Descriptor file(open(path.c_str(), O_WRONLY | O_CLOEXEC), path);
  file.write(content);
  file.finish();
}

}  // namespace handmap
