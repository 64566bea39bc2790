// What stands at the end of an MCAP, so that readers can jump: made while it is written, or again
// of one that was cut off.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/bags/field_writer.h"
#include "core/bags/mcap_format.h"

namespace handmap {

/// A chunk and the indexes of its messages, which follow it.
struct McapChunk {
  std::uint64_t first_ns = 0;
  std::uint64_t last_ns = 0;
  std::uint64_t at = 0;     ///< in the file
  std::uint64_t bytes = 0;  ///< of the record
  std::string packing;
  std::uint64_t packed = 0;  ///< bytes of its messages
  std::uint64_t plain = 0;
  FieldWriter offsets = {};                            ///< topic, place of its index, …
  std::uint64_t index_bytes = 0;                       ///< of all of these
  std::map<std::uint16_t, std::uint64_t> counts = {};  ///< messages by topic
};

class McapSummary {
 public:
  /// Records as they stand in the file.
  void addSchema(std::string_view record);
  void addTopic(std::uint16_t topic, std::string_view record);
  void add(const McapChunk& chunk);
  /// Of `bytes` at `at`, as their records tell.
  void addAttachment(std::uint64_t at, std::uint64_t bytes, std::string_view content);
  void addNote(std::uint64_t at, std::uint64_t bytes, const std::string& name);

  std::size_t topics() const { return counts_.size(); }
  /// What ends a file whose data end at `at`.
  std::string tail(std::uint64_t at) const;

 private:
  std::string declared_;
  std::uint16_t schemas_ = 0;
  std::map<std::uint16_t, std::uint64_t> counts_;
  std::string chunk_indexes_;
  std::string other_indexes_;  ///< of attachments and notes
  std::uint32_t chunks_ = 0;
  std::uint32_t attachments_ = 0;
  std::uint32_t notes_ = 0;
  std::uint64_t first_ns_ = UINT64_MAX;
  std::uint64_t last_ns_ = 0;
};

std::string mcapRecord(McapRecord kind, std::string_view content);
/// The same with nothing to jump by.
std::string mcapTail(std::string_view summary, std::uint64_t at);

}  // namespace handmap
