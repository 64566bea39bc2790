// The end of an MCAP that was cut off: what there is of it is walked through, as it was written.
#include <cerrno>
#include <cstring>
#include <optional>

#include <fcntl.h>
#include <unistd.h>

#include "core/bags/bag_file.h"
#include "core/bags/field_reader.h"
#include "core/bags/mcap_summary.h"
#include "core/bags/mcap_writer.h"
#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr std::uint64_t kMostHead = 1 << 16;  // bytes of a record that tell what its index says

class Unfinished {
 public:
  explicit Unfinished(const BagFile& file) : file_(file) {
    try {
      while (readRecord()) {
      }
    } catch (const Error& error) {
      if (error.code() != ErrorCode::BadInput) throw;  // damaged: from there on it is cut off
    }
  }

  bool isWhole() const { return is_whole_; }
  std::uint64_t end() const { return end_; }
  std::string tail() const { return summary_.tail(end_); }

 private:
  /// False behind the last one that is whole.
  bool readRecord() {
    if (!file_.has(at_, kMcapRecordHead)) return false;
    const std::string head = file_.read(at_, kMcapRecordHead);
    FieldReader reader(head, file_.name());
    const auto kind = static_cast<McapRecord>(reader.get<std::uint8_t>());
    const auto bytes = reader.get<std::uint64_t>();
    const bool is_known = kind >= McapRecord::Header && kind <= McapRecord::DataEnd;
    if (!is_known || !file_.has(at_ + kMcapRecordHead, bytes)) return false;
    const std::uint64_t next = at_ + kMcapRecordHead + bytes;
    if (kind == McapRecord::Footer) {
      is_whole_ = next + kMcapMagic.size() == file_.size() &&
                  file_.read(next, kMcapMagic.size()) == kMcapMagic;
      return false;
    }
    // Only what follows says that a chunk has all its indexes.
    if (chunk_ && kind != McapRecord::MessageIndex) {
      summary_.add(*chunk_);
      chunk_.reset();
      end_ = at_;
    }
    is_ended_ = is_ended_ || kind == McapRecord::DataEnd;
    if (!is_ended_) take(kind, bytes, next);
    at_ = next;
    return true;
  }

  void take(McapRecord kind, std::uint64_t bytes, std::uint64_t next) {
    const bool is_kept = kind == McapRecord::Schema || kind == McapRecord::Channel ||
                         kind == McapRecord::MessageIndex;
    const std::string content =
        file_.read(at_ + kMcapRecordHead, is_kept ? bytes : std::min(bytes, kMostHead));
    FieldReader reader(content, file_.name());
    if (kind == McapRecord::Schema) summary_.addSchema(mcapRecord(kind, content));
    if (kind == McapRecord::Channel) {
      summary_.addTopic(reader.get<std::uint16_t>(), mcapRecord(kind, content));
    }
    if (kind == McapRecord::Attachment) summary_.addAttachment(at_, next - at_, content);
    if (kind == McapRecord::Metadata) summary_.addNote(at_, next - at_, reader.text());
    if (kind == McapRecord::MessageIndex) takeIndex(reader, next);
    if (kind == McapRecord::Chunk) {
      takeChunk(reader, next);
    } else if (!chunk_) {
      end_ = next;
    }
  }

  void takeChunk(FieldReader& reader, std::uint64_t next) {
    McapChunk& chunk = chunk_.emplace();
    chunk.first_ns = reader.get<std::uint64_t>();
    chunk.last_ns = reader.get<std::uint64_t>();
    chunk.plain = reader.get<std::uint64_t>();
    reader.get<std::uint32_t>();  // checksum
    chunk.packing = reader.text();
    chunk.packed = reader.get<std::uint64_t>();
    chunk.at = at_;
    chunk.bytes = next - at_;
  }

  void takeIndex(FieldReader& reader, std::uint64_t next) {
    if (!chunk_) return;
    constexpr std::size_t kEntry = 16;  // bytes: time and place
    const auto topic = reader.get<std::uint16_t>();
    chunk_->offsets.put(topic);
    chunk_->offsets.put(at_);
    chunk_->index_bytes += next - at_;
    chunk_->counts[topic] += reader.count(1) / kEntry;
  }

  const BagFile& file_;
  McapSummary summary_;
  std::optional<McapChunk> chunk_;
  std::uint64_t at_ = kMcapMagic.size();
  std::uint64_t end_ = kMcapMagic.size();  ///< of what is whole
  bool is_ended_ = false;                  ///< what follows can be made again
  bool is_whole_ = false;
};

}  // namespace

bool finishMcap(const std::filesystem::path& path) {
  const BagFile file(path);
  if (!file.has(0, kMcapMagic.size()) || file.read(0, kMcapMagic.size()) != kMcapMagic) {
    throwBadInput(file.name(), "", phrase("another beginning"), "MCAP0");
  }
  const Unfinished unfinished(file);
  if (unfinished.isWhole()) return false;
  const std::string tail = unfinished.tail();
  const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  const auto end = static_cast<off_t>(unfinished.end());
  const auto bytes = static_cast<ssize_t>(tail.size());
  const bool is_written = descriptor >= 0 &&
                          pwrite(descriptor, tail.data(), tail.size(), end) == bytes &&
                          ftruncate(descriptor, end + bytes) == 0;
  const int reason = errno;
  if (descriptor >= 0) close(descriptor);
  if (is_written) return true;
  throw Error(ErrorCode::RunFailed,
              phrase("{}: cannot be written: {}", file.name(), std::strerror(reason)));
}

}  // namespace handmap
