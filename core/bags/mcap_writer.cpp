#include "core/bags/mcap_writer.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

#include <fcntl.h>
#include <unistd.h>
#include <zstd.h>

#include "core/bags/bag_file.h"
#include "core/bags/field_reader.h"
#include "core/bags/mcap_format.h"
#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr std::uint64_t kChunk_ns = 1'000'000'000;
constexpr std::size_t kChunkBytes = 4u << 20;
constexpr int kZstdLevel = 1;

std::uint64_t nanosecondsOf(double time_s) {
  return static_cast<std::uint64_t>(std::llround(std::max(0.0, time_s) * 1e9));
}

std::string record(McapRecord kind, std::string_view content) {
  FieldWriter writer;
  writer.put(static_cast<std::uint8_t>(kind));
  writer.sized<std::uint64_t>(content);
  return writer.bytes();
}

std::string tailOf(std::string_view summary, std::uint64_t at) {
  FieldWriter end;
  end.put(std::uint32_t{0});  // no checksum of the data
  const std::string data_end = record(McapRecord::DataEnd, end.bytes());
  FieldWriter footer;
  footer.put(summary.empty() ? std::uint64_t{0} : at + data_end.size());
  footer.put(std::uint64_t{0});  // no offsets of the parts of the summary
  footer.put(std::uint32_t{0});
  return data_end + std::string(summary) + record(McapRecord::Footer, footer.bytes()) +
         std::string(kMcapMagic);
}

std::string packedByZstd(const std::string& plain) {
  std::string packed(ZSTD_compressBound(plain.size()), '\0');
  packed.resize(
      ZSTD_compress(packed.data(), packed.size(), plain.data(), plain.size(), kZstdLevel));
  return packed;
}

FieldWriter textMap(const std::map<std::string, std::string>& values) {
  FieldWriter inner;
  for (const auto& [key, value] : values) {
    inner.text(key);
    inner.text(value);
  }
  return inner;
}

/// Where what was written last is no more whole; nullopt: nowhere.
std::optional<std::uint64_t> cutOf(const BagFile& file) {
  std::uint64_t at = kMcapMagic.size();
  std::uint64_t end = 0;  // of the data: behind it there is what can be made again
  while (file.has(at, kMcapRecordHead)) {
    const std::string head = file.read(at, kMcapRecordHead);
    FieldReader reader(head, file.name());
    const auto kind = static_cast<McapRecord>(reader.get<std::uint8_t>());
    const auto bytes = reader.get<std::uint64_t>();
    const bool is_known = kind >= McapRecord::Header && kind <= McapRecord::DataEnd;
    if (!is_known || !file.has(at + kMcapRecordHead, bytes)) break;
    if (kind == McapRecord::DataEnd) end = at;
    at += kMcapRecordHead + bytes;
    const std::uint64_t magic = kMcapMagic.size();
    const bool is_whole = kind == McapRecord::Footer && at + magic == file.size() &&
                          file.read(at, magic) == kMcapMagic;
    if (is_whole) return std::nullopt;
  }
  return end != 0 ? end : at;
}

}  // namespace

bool finishMcap(const std::filesystem::path& path) {
  const BagFile file(path);
  if (!file.has(0, kMcapMagic.size()) || file.read(0, kMcapMagic.size()) != kMcapMagic) {
    throwBadInput(file.name(), "", phrase("another beginning"), "MCAP0");
  }
  const auto cut = cutOf(file);
  if (!cut) return false;
  const std::string tail = tailOf({}, *cut);
  const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  const auto bytes = static_cast<off_t>(*cut);
  const bool is_written =
      descriptor >= 0 &&
      pwrite(descriptor, tail.data(), tail.size(), bytes) == static_cast<ssize_t>(tail.size()) &&
      ftruncate(descriptor, bytes + static_cast<off_t>(tail.size())) == 0;
  const int reason = errno;
  if (descriptor >= 0) close(descriptor);
  if (is_written) return true;
  throw Error(ErrorCode::RunFailed,
              phrase("{}: cannot be written: {}", file.name(), std::strerror(reason)));
}

McapWriter::McapWriter(const std::filesystem::path& path)
    : path_(path), descriptor_(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  FieldWriter header;
  header.text("ros2");
  header.text("handmap " HANDMAP_VERSION);
  const std::string head = std::string(kMcapMagic) + record(McapRecord::Header, header.bytes());
  append(head, tailOf({}, head.size()));
}

McapWriter::~McapWriter() {
  if (descriptor_ >= 0) close(descriptor_);
}

void McapWriter::append(std::string_view bytes, std::string_view tail) {
  const std::string all = std::string(bytes) + std::string(tail);
  std::size_t done = 0;
  while (done < all.size()) {
    const ssize_t count = descriptor_ < 0
                              ? -1
                              : pwrite(descriptor_, all.data() + done, all.size() - done,
                                       static_cast<off_t>(end_ + done));
    if (count < 0 && descriptor_ >= 0 && errno == EINTR) continue;
    if (count < 0) {
      throw Error(ErrorCode::RunFailed,
                  phrase("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
    }
    done += static_cast<std::size_t>(count);
  }
  end_ += bytes.size();
}

std::uint16_t McapWriter::addTopic(const std::string& name, const std::string& type,
                                   const std::string& definition) {
  std::string records;
  const auto known = schemas_.find(type);
  const auto schema =
      known != schemas_.end() ? known->second : static_cast<std::uint16_t>(schemas_.size() + 1);
  if (known == schemas_.end()) {
    schemas_[type] = schema;
    FieldWriter fields;
    fields.put(schema);
    fields.text(type);
    fields.text("ros2msg");
    fields.sized<std::uint32_t>(definition);
    records += record(McapRecord::Schema, fields.bytes());
  }
  const auto topic = static_cast<std::uint16_t>(counts_.size());
  FieldWriter fields;
  fields.put(topic);
  fields.put(schema);
  fields.text(name);
  fields.text("cdr");
  fields.sized<std::uint32_t>({});
  records += record(McapRecord::Channel, fields.bytes());
  counts_.push_back(0);
  declared_ += records;
  append(records, tailOf({}, end_ + records.size()));
  return topic;
}

void McapWriter::write(std::uint16_t topic, double time_s, std::string_view message) {
  const std::uint64_t time_ns = nanosecondsOf(time_s);
  const bool is_full = !chunk_.empty() && (chunk_.size() + message.size() > kChunkBytes ||
                                           time_ns > chunk_first_ + kChunk_ns);
  if (is_full) writeChunk();
  if (chunk_.empty()) chunk_first_ = chunk_last_ = time_ns;
  chunk_first_ = std::min(chunk_first_, time_ns);
  chunk_last_ = std::max(chunk_last_, time_ns);
  first_ = std::min(first_, time_ns);
  last_ = std::max(last_, time_ns);
  index_[topic].messages.emplace_back(time_ns, chunk_.size());
  FieldWriter fields;
  fields.put(topic);
  fields.put(static_cast<std::uint32_t>(counts_[topic]++));
  fields.put(time_ns);
  fields.put(time_ns);
  fields.raw(message);
  chunk_ += record(McapRecord::Message, fields.bytes());
}

void McapWriter::writeChunk() {
  if (chunk_.empty()) return;
  FieldWriter fields;
  fields.put(chunk_first_);
  fields.put(chunk_last_);
  fields.put(static_cast<std::uint64_t>(chunk_.size()));
  fields.put(mcapChecksum(chunk_));
  fields.text("zstd");
  const std::string packed = packedByZstd(chunk_);
  fields.sized<std::uint64_t>(packed);
  std::string records = record(McapRecord::Chunk, fields.bytes());
  const std::uint64_t chunk_bytes = records.size();
  FieldWriter offsets;
  for (const auto& [topic, indexed] : index_) {
    offsets.put(topic);
    offsets.put(end_ + records.size());
    FieldWriter entries;
    for (const auto& [time_ns, place] : indexed.messages) {
      entries.put(time_ns);
      entries.put(place);
    }
    FieldWriter index;
    index.put(topic);
    index.sized<std::uint32_t>(entries.bytes());
    records += record(McapRecord::MessageIndex, index.bytes());
  }
  FieldWriter index;
  index.put(chunk_first_);
  index.put(chunk_last_);
  index.put(end_);
  index.put(chunk_bytes);
  index.sized<std::uint32_t>(offsets.bytes());
  index.put(static_cast<std::uint64_t>(records.size() - chunk_bytes));
  index.text("zstd");
  index.put(static_cast<std::uint64_t>(packed.size()));
  index.put(static_cast<std::uint64_t>(chunk_.size()));
  chunk_indexes_ += record(McapRecord::ChunkIndex, index.bytes());
  ++chunks_;
  append(records, tailOf({}, end_ + records.size()));
  chunk_.clear();
  index_.clear();
}

void McapWriter::attach(const std::string& name, const std::string& media_type, double time_s,
                        std::string_view content) {
  FieldWriter fields;
  fields.put(nanosecondsOf(time_s));
  fields.put(nanosecondsOf(time_s));
  fields.text(name);
  fields.text(media_type);
  fields.sized<std::uint64_t>(content);
  fields.put(mcapChecksum(fields.bytes()));
  const std::string records = record(McapRecord::Attachment, fields.bytes());
  FieldWriter index;
  index.put(end_);
  index.put(static_cast<std::uint64_t>(records.size()));
  index.put(nanosecondsOf(time_s));
  index.put(nanosecondsOf(time_s));
  index.put(static_cast<std::uint64_t>(content.size()));
  index.text(name);
  index.text(media_type);
  other_indexes_ += record(McapRecord::AttachmentIndex, index.bytes());
  ++attachments_;
  append(records, tailOf({}, end_ + records.size()));
}

void McapWriter::note(const std::string& name, const std::map<std::string, std::string>& values) {
  FieldWriter fields;
  fields.text(name);
  fields.sized<std::uint32_t>(textMap(values).bytes());
  const std::string records = record(McapRecord::Metadata, fields.bytes());
  FieldWriter index;
  index.put(end_);
  index.put(static_cast<std::uint64_t>(records.size()));
  index.text(name);
  other_indexes_ += record(McapRecord::MetadataIndex, index.bytes());
  ++notes_;
  append(records, tailOf({}, end_ + records.size()));
}

void McapWriter::finish() {
  writeChunk();
  std::uint64_t messages = 0;
  FieldWriter counts;
  for (std::size_t topic = 0; topic < counts_.size(); ++topic) {
    messages += counts_[topic];
    counts.put(static_cast<std::uint16_t>(topic));
    counts.put(counts_[topic]);
  }
  FieldWriter statistics;
  statistics.put(messages);
  statistics.put(static_cast<std::uint16_t>(schemas_.size()));
  statistics.put(static_cast<std::uint32_t>(counts_.size()));
  statistics.put(attachments_);
  statistics.put(notes_);
  statistics.put(chunks_);
  statistics.put(messages > 0 ? first_ : std::uint64_t{0});
  statistics.put(last_);
  statistics.sized<std::uint32_t>(counts.bytes());
  append({}, tailOf(declared_ + record(McapRecord::Statistics, statistics.bytes()) +
                        chunk_indexes_ + other_indexes_,
                    end_));
}

}  // namespace handmap
