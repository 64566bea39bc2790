// What reader and writer of MCAP share.
#pragma once

#include <cstdint>
#include <string_view>

namespace handmap {

inline constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";
inline constexpr std::uint64_t kMcapRecordHead = 9;  // kind and length

enum class McapRecord : std::uint8_t {
  Header = 1,
  Footer,
  Schema,
  Channel,
  Message,
  Chunk,
  MessageIndex,
  ChunkIndex,
  Attachment,
  AttachmentIndex,
  Statistics,
  Metadata,
  MetadataIndex,
  SummaryOffset,
  DataEnd
};

/// CRC-32 of IEEE 802.3.
std::uint32_t mcapChecksum(std::string_view bytes);

}  // namespace handmap
