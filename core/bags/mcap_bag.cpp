// MCAP: records of a kind, a length and a content; messages stand alone or in chunks.
#include <map>
#include <optional>
#include <utility>

#include <zlib.h>

#include "core/bags/bag_file.h"
#include "core/bags/bag_kinds.h"
#include "core/bags/mcap_format.h"
#include "core/bags/packed.h"
#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

MessageEncoding encodingOf(const std::string& name) {
  if (name == "cdr") return MessageEncoding::Cdr;
  return name == "ros1" ? MessageEncoding::Ros1 : MessageEncoding::Other;
}

class McapBag : public Bag {
 public:
  McapBag(const std::filesystem::path& path, const std::stop_token& stop)
      : Bag(path, "MCAP"), file_(path) {
    if (!file_.has(0, kMcapMagic.size()) || file_.read(0, kMcapMagic.size()) != kMcapMagic) {
      throwBadInput(file_.name(), "", phrase("another beginning"), "MCAP0");
    }
    if (!listByIndex(stop)) listByReading(stop);
  }

  void read(const std::vector<bool>& wanted, const Take& take,
            const std::stop_token& stop) const override {
    const auto pass_on = [&](McapRecord kind, FieldReader content) {
      if (kind != McapRecord::Message) return;
      const auto topic = topic_of_.find(content.get<std::uint16_t>());
      if (topic == topic_of_.end() || !wanted[topic->second]) return;
      content.get<std::uint32_t>();  // its number
      const double time_s = content.nanoseconds();
      content.nanoseconds();  // when it was published
      take({topic->second, time_s, content.take(content.left())});
    };
    walk(stop, [&](McapRecord kind, std::uint64_t at, std::uint64_t bytes) {
      if (kind == McapRecord::Chunk) inChunk(at, bytes, pass_on);
      if (kind != McapRecord::Message) return;
      const std::string content = file_.read(at, bytes);
      pass_on(kind, FieldReader(content, sourceAt(at)));
    });
  }

 private:
  /// As Ros1Bag::walk().
  template <typename Visit>
  std::optional<std::uint64_t> walk(const std::stop_token& stop, const Visit& visit) const {
    std::uint64_t at = kMcapMagic.size();
    const std::uint64_t end = file_.size();
    while (true) {
      throwIfStopped(stop);
      if (!file_.has(at, kMcapRecordHead)) return at;
      const std::string head = file_.read(at, kMcapRecordHead);
      FieldReader reader(head, sourceAt(at));
      const auto kind = static_cast<McapRecord>(reader.get<std::uint8_t>());
      const auto bytes = reader.get<std::uint64_t>();
      if (!file_.has(at + kMcapRecordHead, bytes)) return at;
      visit(kind, at + kMcapRecordHead, bytes);
      at += kMcapRecordHead + bytes;
      if (kind == McapRecord::Footer)
        return at + kMcapMagic.size() == end ? std::nullopt : std::optional(at);
    }
  }

  template <typename Visit>
  void inChunk(std::uint64_t at, std::uint64_t bytes, const Visit& visit) const {
    const std::string chunk = file_.read(at, bytes);
    FieldReader head(chunk, sourceAt(at));
    head.take(16);  // the times of its first and last message
    head.get<std::uint64_t>();
    const auto checksum = head.get<std::uint32_t>();
    const std::string packing = head.text();
    const std::string records = unpacked(packing, head.takeSized<std::uint64_t>(), file_.name(),
                                         phrase("chunk at byte {}", at));
    if (checksum != 0 && checksum != mcapChecksum(records)) {
      throwBadInput(file_.name(), phrase("chunk at byte {}", at), phrase("damaged bytes"),
                    phrase("those of its checksum"));
    }
    FieldReader reader(records, sourceAt(at));
    while (reader.left() > 0) {
      const auto kind = static_cast<McapRecord>(reader.get<std::uint8_t>());
      visit(kind, FieldReader(reader.takeSized<std::uint64_t>(), sourceAt(at)));
    }
  }

  void addDeclaration(McapRecord kind, FieldReader content) {
    if (kind == McapRecord::Schema) {
      const auto id = content.get<std::uint16_t>();
      type_of_[id] = content.text();
    }
    if (kind == McapRecord::Channel) {
      const auto id = content.get<std::uint16_t>();
      const auto type = type_of_.find(content.get<std::uint16_t>());
      const std::string name = content.text();
      topic_of_[id] = topicOf(name, type == type_of_.end() ? std::string() : type->second,
                              encodingOf(content.text()));
    }
  }

  bool listByIndex(const std::stop_token& stop) {
    std::map<std::uint16_t, std::vector<double>> times;
    bool is_indexed = true;  ///< the chunk before
    bool all_indexed = true;
    bool messages_alone = false;
    const auto cut = walk(stop, [&](McapRecord kind, std::uint64_t at, std::uint64_t bytes) {
      messages_alone = messages_alone || kind == McapRecord::Message;
      if (kind == McapRecord::Chunk) all_indexed = all_indexed && std::exchange(is_indexed, false);
      if (kind == McapRecord::Schema || kind == McapRecord::Channel) {
        const std::string content = file_.read(at, bytes);
        addDeclaration(kind, FieldReader(content, sourceAt(at)));
      }
      if (kind != McapRecord::MessageIndex) return;
      is_indexed = true;
      const std::string content = file_.read(at, bytes);
      FieldReader reader(content, sourceAt(at));
      auto& of_channel = times[reader.get<std::uint16_t>()];
      for (std::size_t left = reader.count(1) / 16; left > 0; --left) {
        of_channel.push_back(reader.nanoseconds());
        reader.get<std::uint64_t>();
      }
    });
    if (cut || !all_indexed || !is_indexed || messages_alone) return false;
    for (const auto& [channel, all] : times) {
      const auto topic = topic_of_.find(channel);
      if (topic == topic_of_.end()) return false;
      for (const double time_s : all) count(topic->second, time_s);
    }
    return true;
  }

  void listByReading(const std::stop_token& stop) {
    clearCounts();
    const auto add = [&](McapRecord kind, FieldReader content) {
      addDeclaration(kind, content);
      if (kind != McapRecord::Message) return;
      const auto topic = topic_of_.find(content.get<std::uint16_t>());
      content.get<std::uint32_t>();
      if (topic != topic_of_.end()) count(topic->second, content.nanoseconds());
    };
    const auto cut = walk(stop, [&](McapRecord kind, std::uint64_t at, std::uint64_t bytes) {
      if (kind == McapRecord::Chunk) inChunk(at, bytes, add);
      if (kind != McapRecord::Schema && kind != McapRecord::Channel && kind != McapRecord::Message)
        return;
      const std::string content = file_.read(at, bytes);
      add(kind, FieldReader(content, sourceAt(at)));
    });
    if (cut)
      note(phrase("{}: cut off at byte {}: what is before that is read", file_.name(), *cut));
  }

  std::string sourceAt(std::uint64_t at) const {
    return file_.name() + ": " + phrase("record at byte {}", at);
  }

  BagFile file_;
  std::map<std::uint16_t, std::string> type_of_;   ///< by schema
  std::map<std::uint16_t, std::size_t> topic_of_;  ///< by channel
};

}  // namespace

std::uint32_t mcapChecksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::unique_ptr<Bag> openMcap(const std::filesystem::path& path, const std::stop_token& stop) {
  return std::make_unique<McapBag>(path, stop);
}

}  // namespace handmap
