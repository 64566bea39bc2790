// Bags made for tests: the same messages as a ROS 1 bag, as MCAP and in SQLite.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <bzlib.h>
#include <lz4frame.h>
#include <sqlite3.h>

#include "core/bags/bag.h"
#include "core/bags/field_writer.h"
#include "core/bags/mcap_writer.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap::test {

struct MadeMessage {
  std::string topic;
  std::string type;  ///< "sensor_msgs/LaserScan"
  double time_s = 0.0;
  /// Writes the fields; the header of a message by header().
  std::function<void(FieldWriter&, MessageEncoding)> fields;

  std::string bytes(MessageEncoding encoding) const {
    FieldWriter writer = encoding == MessageEncoding::Cdr ? FieldWriter::cdr() : FieldWriter();
    fields(writer, encoding);
    return writer.bytes();
  }
};

inline void header(FieldWriter& to, MessageEncoding encoding, double time_s,
                   const std::string& frame) {
  if (encoding == MessageEncoding::Ros1) to.put(std::uint32_t{7});
  to.stamp(time_s);
  to.text(frame);
}

inline std::string ros1Record(const std::map<std::string, std::string>& head,
                              const std::string& data) {
  FieldWriter fields;
  for (const auto& [name, value] : head) fields.sized<std::uint32_t>(name + "=" + value);
  FieldWriter record;
  record.sized<std::uint32_t>(fields.bytes());
  record.sized<std::uint32_t>(data);
  return record.bytes();
}

template <typename Number>
std::string rawNumber(Number value) {
  FieldWriter writer;
  writer.put(value);
  return writer.bytes();
}

inline std::string rawStamp(double time_s) {
  FieldWriter writer;
  writer.stamp(time_s);
  return writer.bytes();
}

inline std::string packedBy(const std::string& packing, const std::string& plain) {
  std::string packed(plain.size() + plain.size() / 50 + 1024, '\0');
  if (packing == "bz2") {
    auto size = static_cast<unsigned>(packed.size());
    BZ2_bzBuffToBuffCompress(packed.data(), &size, const_cast<char*>(plain.data()),
                             static_cast<unsigned>(plain.size()), 9, 0, 0);
    packed.resize(size);
    return packed;
  }
  if (packing == "lz4") {
    packed.resize(LZ4F_compressFrameBound(plain.size(), nullptr));
    packed.resize(
        LZ4F_compressFrame(packed.data(), packed.size(), plain.data(), plain.size(), nullptr));
    return packed;
  }
  return plain;
}

/// One chunk a message, with its index, and the connections once more at the end.
inline std::string ros1Bag(const std::vector<MadeMessage>& messages, const std::string& packing,
                           bool indexed = true) {
  std::string bag = "#ROSBAG V2.0\n";
  bag += ros1Record({{"op", "\x03"},
                     {"index_pos", rawNumber(std::uint64_t{0})},
                     {"conn_count", rawNumber(std::uint32_t{0})},
                     {"chunk_count", rawNumber(std::uint32_t{0})}},
                    std::string(200, ' '));
  std::map<std::string, std::uint32_t> connections;
  std::string end;
  for (const MadeMessage& message : messages) {
    const auto [known, is_new] =
        connections.emplace(message.topic, static_cast<std::uint32_t>(connections.size()));
    const std::string number = rawNumber(known->second);
    std::string chunk;
    if (is_new) {
      FieldWriter fields;
      fields.sized<std::uint32_t>("topic=" + message.topic);
      fields.sized<std::uint32_t>("type=" + message.type);
      const std::string connection =
          ros1Record({{"op", "\x07"}, {"conn", number}, {"topic", message.topic}}, fields.bytes());
      chunk += connection;
      end += connection;
    }
    const std::string place = rawNumber(static_cast<std::uint32_t>(chunk.size()));
    chunk += ros1Record({{"op", "\x02"}, {"conn", number}, {"time", rawStamp(message.time_s)}},
                        message.bytes(MessageEncoding::Ros1));
    bag += ros1Record({{"op", "\x05"},
                       {"compression", packing},
                       {"size", rawNumber(static_cast<std::uint32_t>(chunk.size()))}},
                      packedBy(packing, chunk));
    if (!indexed) continue;
    bag += ros1Record({{"op", "\x04"},
                       {"ver", rawNumber(std::uint32_t{1})},
                       {"conn", number},
                       {"count", rawNumber(std::uint32_t{1})}},
                      rawStamp(message.time_s) + place);
  }
  return indexed ? bag + end : bag;
}

inline std::string ros2Type(std::string type) { return type.insert(type.find('/'), "/msg"); }

inline void writeMcap(const std::filesystem::path& path, const std::vector<MadeMessage>& messages) {
  McapWriter writer(path);
  std::map<std::string, std::uint16_t> topics;
  for (const MadeMessage& message : messages) {
    if (!topics.contains(message.topic)) {
      topics[message.topic] = writer.addTopic(message.topic, ros2Type(message.type), "");
    }
    writer.write(topics[message.topic], message.time_s, message.bytes(MessageEncoding::Cdr));
  }
  writer.finish();
}

inline void writeSqlite(const std::filesystem::path& path,
                        const std::vector<MadeMessage>& messages) {
  sqlite3* base = nullptr;
  sqlite3_open(path.c_str(), &base);
  sqlite3_exec(base,
               "BEGIN; CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT "
               "NOT NULL, serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
               "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp "
               "INTEGER NOT NULL, data BLOB NOT NULL);",
               nullptr, nullptr, nullptr);
  std::map<std::string, int> topics;
  for (const MadeMessage& message : messages) {
    if (!topics.contains(message.topic)) {
      const int id = static_cast<int>(topics.size()) + 1;
      topics[message.topic] = id;
      const std::string add = "INSERT INTO topics VALUES(" + std::to_string(id) + ",'" +
                              message.topic + "','" + ros2Type(message.type) + "','cdr','')";
      sqlite3_exec(base, add.c_str(), nullptr, nullptr, nullptr);
    }
    sqlite3_stmt* insert = nullptr;
    sqlite3_prepare_v2(base, "INSERT INTO messages(topic_id,timestamp,data) VALUES(?,?,?)", -1,
                       &insert, nullptr);
    const std::string bytes = message.bytes(MessageEncoding::Cdr);
    sqlite3_bind_int(insert, 1, topics[message.topic]);
    sqlite3_bind_int64(insert, 2, std::llround(message.time_s * 1e9));
    sqlite3_bind_blob(insert, 3, bytes.data(), static_cast<int>(bytes.size()), SQLITE_TRANSIENT);
    sqlite3_step(insert);
    sqlite3_finalize(insert);
  }
  sqlite3_exec(base, "COMMIT", nullptr, nullptr, nullptr);
  sqlite3_close(base);
}

}  // namespace handmap::test
