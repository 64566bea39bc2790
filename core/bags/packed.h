// Parts of bags are packed: bz2, lz4 (its frames) or zstd.
#pragma once

#include <string>
#include <string_view>

namespace handmap {

inline constexpr std::size_t kMostUnpackedBytes = 1u << 30;

/// `packing`: "" or "none", "bz2", "lz4", "zstd". Nothing is allocated on the file's word. Throws
/// BadInput for another one, for what is damaged or cut off, and for more than `most` bytes.
std::string unpacked(std::string_view packing, std::string_view bytes, const std::string& source,
                     const std::string& place, std::size_t most = kMostUnpackedBytes);

}  // namespace handmap
