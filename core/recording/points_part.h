// Points of many frames in one file; frames.csv tells which of its bytes are whose.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace handmap {

struct PointsPart {
  std::filesystem::path file;
  std::uintmax_t offset = 0;  ///< bytes
  std::uintmax_t bytes = 0;
};

/// Of "FILE@OFFSET+BYTES"; nullopt for the name of a whole file.
std::optional<PointsPart> partOf(const std::filesystem::path& path);

}  // namespace handmap
