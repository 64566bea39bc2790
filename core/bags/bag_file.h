// A file that is read here and there, as large as it may be.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace handmap {

class BagFile {
 public:
  /// Throws BadInput where there is no such file.
  explicit BagFile(const std::filesystem::path& path);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  std::uint64_t size() const { return size_; }
  bool has(std::uint64_t offset, std::uint64_t bytes) const {
    return offset <= size_ && bytes <= size_ - offset;
  }
  /// Throws BadInput beyond the end, or for more than a gigabyte at once.
  std::string read(std::uint64_t offset, std::uint64_t bytes) const;
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace handmap
