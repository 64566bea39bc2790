// ROS 1 bags, version 2.0: records of a header (fields NAME=VALUE) and data; messages stand in
// chunks, each followed by an index.
#include <map>
#include <optional>
#include <utility>

#include "core/bags/bag_file.h"
#include "core/bags/bag_kinds.h"
#include "core/bags/packed.h"
#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr int kMessage = 2;
constexpr int kIndex = 4;
constexpr int kChunk = 5;
constexpr int kConnection = 7;
constexpr std::uint32_t kMostHeaderBytes = 1u << 24;

/// NAME=VALUE each, as in the header of a record and in the data of a connection.
std::map<std::string_view, std::string_view> namedFields(std::string_view bytes,
                                                         const std::string& source) {
  std::map<std::string_view, std::string_view> fields;
  FieldReader reader(bytes, source);
  while (reader.left() > 0) {
    const std::string_view field = reader.takeSized<std::uint32_t>();
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) reader.fail(phrase("no field"), "NAME=VALUE");
    fields[field.substr(0, equals)] = field.substr(equals + 1);
  }
  return fields;
}

class RecordHead {
 public:
  RecordHead(std::string_view bytes, std::string source)
      : source_(std::move(source)), fields_(namedFields(bytes, source_)) {}

  template <typename Number>
  Number number(std::string_view name) const {
    return FieldReader(text(name), source_).get<Number>();
  }
  double time() const { return FieldReader(text("time"), source_).stamp(); }
  std::string_view text(std::string_view name) const {
    const auto found = fields_.find(name);
    return found == fields_.end() ? std::string_view() : found->second;
  }
  int kind() const { return number<std::uint8_t>("op"); }

 private:
  std::string source_;
  std::map<std::string_view, std::string_view> fields_;
};

class Ros1Bag : public Bag {
 public:
  Ros1Bag(const std::filesystem::path& path, const std::stop_token& stop)
      : Bag(path, "ROS 1 bag"), file_(path) {
    if (!file_.has(0, kMagic.size()) || file_.read(0, kMagic.size()) != kMagic) {
      throwBadInput(file_.name(), "", phrase("another beginning"), "#ROSBAG V2.0");
    }
    if (!listByIndex(stop)) listByReading(stop);
  }

  void read(const std::vector<bool>& wanted, const Take& take,
            const std::stop_token& stop) const override {
    const auto pass_on = [&](const RecordHead& head, std::string_view data) {
      if (head.kind() != kMessage) return;
      const auto topic = topic_of_.find(head.number<std::uint32_t>("conn"));
      if (topic == topic_of_.end() || !wanted[topic->second]) return;
      take({topic->second, head.time(), data});
    };
    walk(stop, [&](const RecordHead& head, std::uint64_t at, std::uint64_t bytes) {
      if (head.kind() == kChunk) inChunk(head, at, bytes, pass_on);
      if (head.kind() == kMessage) pass_on(head, file_.read(at, bytes));
    });
  }

 private:
  /// Goes through the records up to the end or to where the file is cut off, which it gives.
  template <typename Visit>
  std::optional<std::uint64_t> walk(const std::stop_token& stop, const Visit& visit) const {
    std::uint64_t at = kMagic.size();
    while (at < file_.size()) {
      throwIfStopped(stop);
      const std::uint64_t begin = at;
      if (!file_.has(at, 4)) return begin;
      const auto head_bytes = sizeAt(at);
      if (!file_.has(at + 4, std::uint64_t{head_bytes} + 4)) return begin;
      if (head_bytes > kMostHeaderBytes) {
        throwBadInput(file_.name(), phrase("byte {}", at), phrase("{} bytes", head_bytes),
                      phrase("at most {} bytes", kMostHeaderBytes));
      }
      const std::string head = file_.read(at + 4, head_bytes);
      at += 4 + std::uint64_t{head_bytes};
      const std::uint64_t bytes = sizeAt(at);
      at += 4;
      if (!file_.has(at, bytes)) return begin;
      visit(RecordHead(head, sourceAt(begin)), at, bytes);
      at += bytes;
    }
    return std::nullopt;
  }

  template <typename Visit>
  void inChunk(const RecordHead& head, std::uint64_t at, std::uint64_t bytes,
               const Visit& visit) const {
    const std::string data = unpacked(head.text("compression"), file_.read(at, bytes), file_.name(),
                                      phrase("byte {}", at));
    FieldReader reader(data, sourceAt(at));
    while (reader.left() > 0) {
      const std::string_view inner = reader.takeSized<std::uint32_t>();
      const std::string_view content = reader.takeSized<std::uint32_t>();
      visit(RecordHead(inner, sourceAt(at)), content);
    }
  }

  void addConnection(const RecordHead& head, std::string_view data) {
    const auto fields = namedFields(data, file_.name());
    const auto type = fields.find("type");
    const std::string name = type == fields.end() ? std::string() : std::string(type->second);
    topic_of_[head.number<std::uint32_t>("conn")] =
        topicOf(std::string(head.text("topic")), name, MessageEncoding::Ros1);
  }

  /// Without unpacking anything. False where the file was cut off before its index was written.
  bool listByIndex(const std::stop_token& stop) {
    std::map<std::uint32_t, std::vector<double>> times;
    bool is_indexed = true;  ///< the chunk before
    bool all_indexed = true;
    const auto cut = walk(stop, [&](const RecordHead& head, std::uint64_t at, std::uint64_t bytes) {
      if (head.kind() == kConnection) addConnection(head, file_.read(at, bytes));
      if (head.kind() == kChunk) all_indexed = all_indexed && std::exchange(is_indexed, false);
      if (head.kind() != kIndex) return;
      is_indexed = true;
      const std::string data = file_.read(at, bytes);
      FieldReader reader(data, sourceAt(at));
      auto& of_connection = times[head.number<std::uint32_t>("conn")];
      for (auto left = head.number<std::uint32_t>("count"); left > 0; --left) {
        of_connection.push_back(reader.stamp());
        reader.get<std::uint32_t>();
      }
    });
    if (cut || !all_indexed || !is_indexed) return false;
    for (const auto& [connection, all] : times) {
      const auto topic = topic_of_.find(connection);
      if (topic == topic_of_.end()) return false;
      for (const double time_s : all) count(topic->second, time_s);
    }
    return true;
  }

  void listByReading(const std::stop_token& stop) {
    clearCounts();
    const auto add = [&](const RecordHead& head, std::string_view data) {
      if (head.kind() == kConnection) addConnection(head, data);
      if (head.kind() != kMessage) return;
      const auto topic = topic_of_.find(head.number<std::uint32_t>("conn"));
      if (topic != topic_of_.end()) count(topic->second, head.time());
    };
    const auto cut = walk(stop, [&](const RecordHead& head, std::uint64_t at, std::uint64_t bytes) {
      if (head.kind() == kChunk) inChunk(head, at, bytes, add);
      if (head.kind() == kConnection || head.kind() == kMessage) add(head, file_.read(at, bytes));
    });
    if (cut)
      note(phrase("{}: cut off at byte {}: what is before that is read", file_.name(), *cut));
  }

  std::uint32_t sizeAt(std::uint64_t at) const {
    return FieldReader(file_.read(at, 4), file_.name()).get<std::uint32_t>();
  }
  std::string sourceAt(std::uint64_t at) const {
    return file_.name() + ": " + phrase("record at byte {}", at);
  }

  BagFile file_;
  std::map<std::uint32_t, std::size_t> topic_of_;  ///< by connection
};

}  // namespace

std::unique_ptr<Bag> openRos1Bag(const std::filesystem::path& path, const std::stop_token& stop) {
  return std::make_unique<Ros1Bag>(path, stop);
}

}  // namespace handmap
