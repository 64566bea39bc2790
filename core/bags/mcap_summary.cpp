#include "core/bags/mcap_summary.h"

#include <algorithm>

#include "core/bags/field_reader.h"

namespace handmap {

std::string mcapRecord(McapRecord kind, std::string_view content) {
  FieldWriter writer;
  writer.put(static_cast<std::uint8_t>(kind));
  writer.sized<std::uint64_t>(content);
  return writer.bytes();
}

std::string mcapTail(std::string_view summary, std::uint64_t at) {
  FieldWriter end;
  end.put(std::uint32_t{0});  // no checksum of the data
  const std::string data_end = mcapRecord(McapRecord::DataEnd, end.bytes());
  FieldWriter footer;
  footer.put(summary.empty() ? std::uint64_t{0} : at + data_end.size());
  footer.put(std::uint64_t{0});  // no offsets of the parts of the summary
  footer.put(std::uint32_t{0});
  return data_end + std::string(summary) + mcapRecord(McapRecord::Footer, footer.bytes()) +
         std::string(kMcapMagic);
}

void McapSummary::addSchema(std::string_view record) {
  declared_ += record;
  ++schemas_;
}

void McapSummary::addTopic(std::uint16_t topic, std::string_view record) {
  declared_ += record;
  counts_[topic];
}

void McapSummary::add(const McapChunk& chunk) {
  FieldWriter index;
  index.put(chunk.first_ns);
  index.put(chunk.last_ns);
  index.put(chunk.at);
  index.put(chunk.bytes);
  index.sized<std::uint32_t>(chunk.offsets.bytes());
  index.put(chunk.index_bytes);
  index.text(chunk.packing);
  index.put(chunk.packed);
  index.put(chunk.plain);
  chunk_indexes_ += mcapRecord(McapRecord::ChunkIndex, index.bytes());
  ++chunks_;
  for (const auto& [topic, messages] : chunk.counts) counts_[topic] += messages;
  first_ns_ = std::min(first_ns_, chunk.first_ns);
  last_ns_ = std::max(last_ns_, chunk.last_ns);
}

void McapSummary::addAttachment(std::uint64_t at, std::uint64_t bytes, std::string_view content) {
  FieldReader reader(content, "attachment");
  const auto logged = reader.get<std::uint64_t>();
  const auto created = reader.get<std::uint64_t>();
  const std::string name = reader.text();
  const std::string media_type = reader.text();
  FieldWriter index;
  index.put(at);
  index.put(bytes);
  index.put(logged);
  index.put(created);
  index.put(reader.get<std::uint64_t>());
  index.text(name);
  index.text(media_type);
  other_indexes_ += mcapRecord(McapRecord::AttachmentIndex, index.bytes());
  ++attachments_;
}

void McapSummary::addNote(std::uint64_t at, std::uint64_t bytes, const std::string& name) {
  FieldWriter index;
  index.put(at);
  index.put(bytes);
  index.text(name);
  other_indexes_ += mcapRecord(McapRecord::MetadataIndex, index.bytes());
  ++notes_;
}

std::string McapSummary::tail(std::uint64_t at) const {
  std::uint64_t messages = 0;
  FieldWriter counts;
  for (const auto& [topic, count] : counts_) {
    messages += count;
    counts.put(topic);
    counts.put(count);
  }
  FieldWriter statistics;
  statistics.put(messages);
  statistics.put(schemas_);
  statistics.put(static_cast<std::uint32_t>(counts_.size()));
  statistics.put(attachments_);
  statistics.put(notes_);
  statistics.put(chunks_);
  statistics.put(messages > 0 ? first_ns_ : std::uint64_t{0});
  statistics.put(last_ns_);
  statistics.sized<std::uint32_t>(counts.bytes());
  return mcapTail(declared_ + mcapRecord(McapRecord::Statistics, statistics.bytes()) +
                      chunk_indexes_ + other_indexes_,
                  at);
}

}  // namespace handmap
