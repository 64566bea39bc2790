// Writes MCAP: chunks of at most a second, packed by zstd. After each of them the file is whole, so
// that whatever ends the program leaves one that can be read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/bags/mcap_summary.h"

namespace handmap {

/// Gives a file that was cut off (by whatever stops a machine, or a full disk) the end that a whole
/// one has, behind its last whole record. False: it is whole. Throws BadInput for what is no MCAP,
/// RunFailed where it cannot be written.
bool finishMcap(const std::filesystem::path& path);

class McapWriter {
 public:
  /// Replaces what is there. Throws RunFailed.
  explicit McapWriter(const std::filesystem::path& path);
  /// What was not finished stays as its last chunk left it.
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// A topic of CDR messages of a type of ROS 2 ("geometry_msgs/msg/PoseStamped") whose fields
  /// `definition` tells. Gives its number.
  std::uint16_t addTopic(const std::string& name, const std::string& type,
                         const std::string& definition);
  /// Throws RunFailed, as the others do.
  void write(std::uint16_t topic, double time_s, std::string_view message);
  void attach(const std::string& name, const std::string& media_type, double time_s,
              std::string_view content);
  void note(const std::string& name, const std::map<std::string, std::string>& values);
  /// With what lets readers jump.
  void finish();

 private:
  struct Indexed {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> messages;  ///< time and place
  };
  void writeChunk();
  /// Whole behind where the last one ended; `tail` is overwritten by the next.
  void append(std::string_view bytes, std::string_view tail);

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;  ///< of what stays
  McapSummary summary_;
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::uint16_t, std::uint64_t> written_;  ///< messages by topic
  std::string chunk_;
  std::map<std::uint16_t, Indexed> index_;  ///< of the chunk
  std::uint64_t chunk_first_ = 0;
  std::uint64_t chunk_last_ = 0;
};

}  // namespace handmap
