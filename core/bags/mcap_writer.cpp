#include "core/bags/mcap_writer.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

#include <fcntl.h>
#include <unistd.h>
#include <zstd.h>

#include "core/bags/mcap_summary.h"
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

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& path)
    : path_(path), descriptor_(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  FieldWriter header;
  header.text("ros2");
  header.text("handmap " HANDMAP_VERSION);
  const std::string head = std::string(kMcapMagic) + mcapRecord(McapRecord::Header, header.bytes());
  append(head, mcapTail({}, head.size()));
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
    records += mcapRecord(McapRecord::Schema, fields.bytes());
    summary_.addSchema(records);
  }
  const auto topic = static_cast<std::uint16_t>(summary_.topics());
  FieldWriter fields;
  fields.put(topic);
  fields.put(schema);
  fields.text(name);
  fields.text("cdr");
  fields.sized<std::uint32_t>({});
  const std::string channel = mcapRecord(McapRecord::Channel, fields.bytes());
  summary_.addTopic(topic, channel);
  records += channel;
  append(records, mcapTail({}, end_ + records.size()));
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
  index_[topic].messages.emplace_back(time_ns, chunk_.size());
  FieldWriter fields;
  fields.put(topic);
  fields.put(static_cast<std::uint32_t>(written_[topic]++));
  fields.put(time_ns);
  fields.put(time_ns);
  fields.raw(message);
  chunk_ += mcapRecord(McapRecord::Message, fields.bytes());
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
  std::string records = mcapRecord(McapRecord::Chunk, fields.bytes());
  McapChunk chunk{chunk_first_, chunk_last_,   end_,         records.size(),
                  "zstd",       packed.size(), chunk_.size()};
  for (const auto& [topic, indexed] : index_) {
    chunk.offsets.put(topic);
    chunk.offsets.put(end_ + records.size());
    chunk.counts[topic] = indexed.messages.size();
    FieldWriter entries;
    for (const auto& [time_ns, place] : indexed.messages) {
      entries.put(time_ns);
      entries.put(place);
    }
    FieldWriter index;
    index.put(topic);
    index.sized<std::uint32_t>(entries.bytes());
    records += mcapRecord(McapRecord::MessageIndex, index.bytes());
  }
  chunk.index_bytes = records.size() - chunk.bytes;
  summary_.add(chunk);
  append(records, mcapTail({}, end_ + records.size()));
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
  const std::string records = mcapRecord(McapRecord::Attachment, fields.bytes());
  summary_.addAttachment(end_, records.size(), fields.bytes());
  append(records, mcapTail({}, end_ + records.size()));
}

void McapWriter::note(const std::string& name, const std::map<std::string, std::string>& values) {
  FieldWriter fields;
  fields.text(name);
  fields.sized<std::uint32_t>(textMap(values).bytes());
  const std::string records = mcapRecord(McapRecord::Metadata, fields.bytes());
  summary_.addNote(end_, records.size(), name);
  append(records, mcapTail({}, end_ + records.size()));
}

void McapWriter::finish() {
  writeChunk();
  append({}, summary_.tail(end_));
}

}  // namespace handmap
