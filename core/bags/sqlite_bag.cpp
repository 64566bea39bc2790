// ROS 2 bags in SQLite: tables `topics` and `messages`.
#include <map>

#include <fmt/format.h>
#include <sqlite3.h>

#include "core/bags/bag_file.h"
#include "core/bags/bag_kinds.h"
#include "core/bags/packed.h"
#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr std::string_view kSqliteMagic = "SQLite format 3";
constexpr std::string_view kZstdMagic = "\x28\xb5\x2f\xfd";  // what no CDR begins with
constexpr int kMostValueBytes = 1 << 29;

class Statement {
 public:
  Statement(sqlite3* base, const std::string& text, const std::string& file)
      : base_(base), file_(file) {
    if (sqlite3_prepare_v2(base, text.c_str(), -1, &statement_, nullptr) != SQLITE_OK) fail();
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  bool next() {
    const int result = sqlite3_step(statement_);
    if (result != SQLITE_ROW && result != SQLITE_DONE) fail();
    return result == SQLITE_ROW;
  }
  std::int64_t number(int column) { return sqlite3_column_int64(statement_, column); }
  /// Of a text or of bytes.
  std::string_view bytes(int column) {
    const void* data = sqlite3_column_blob(statement_, column);
    const int size = sqlite3_column_bytes(statement_, column);
    return data == nullptr
               ? std::string_view()
               : std::string_view(static_cast<const char*>(data), static_cast<std::size_t>(size));
  }

 private:
  [[noreturn]] void fail() const {
    throwBadInput(file_, "", fmt::format("\"{}\"", sqlite3_errmsg(base_)),
                  phrase("the tables of a ROS 2 bag: topics, messages"));
  }

  sqlite3* base_;
  const std::string& file_;
  sqlite3_stmt* statement_ = nullptr;
};

class SqliteBag : public Bag {
 public:
  SqliteBag(const std::filesystem::path& path, const std::stop_token& stop)
      : Bag(path, "ROS 2 bag (SQLite)"), name_(path.string()) {
    const BagFile file(path);
    if (!file.has(0, kSqliteMagic.size()) || file.read(0, kSqliteMagic.size()) != kSqliteMagic) {
      throwBadInput(name_, "", phrase("another beginning"), std::string(kSqliteMagic));
    }
    open(path);
    list(stop);
  }

  void read(const std::vector<bool>& wanted, const Take& take,
            const std::stop_token& stop) const override {
    Statement messages(base_.get(), "SELECT topic_id, timestamp, data FROM messages ORDER BY id",
                       name_);
    while (messages.next()) {
      throwIfStopped(stop);
      const auto topic = topic_of_.find(messages.number(0));
      if (topic == topic_of_.end() || !wanted[topic->second]) continue;
      std::string_view data = messages.bytes(2);
      std::string plain;
      if (data.starts_with(kZstdMagic)) {
        plain = unpacked("zstd", data, name_, topics()[topic->second].name);
        data = plain;
      }
      take({topic->second, 1e-9 * static_cast<double>(messages.number(1)), data});
    }
  }

 private:
  void open(const std::filesystem::path& path) {
    sqlite3* base = nullptr;
    // Immutable: nobody writes it now, and its folder need not be writable.
    std::string uri = "file:";
    for (const char c : std::filesystem::absolute(path).string()) {
      uri += c == '%' || c == '?' || c == '#' ? fmt::format("%{:02x}", c) : std::string(1, c);
    }
    uri += "?immutable=1";
    const int result =
        sqlite3_open_v2(uri.c_str(), &base, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    base_.reset(base);
    if (result != SQLITE_OK) {
      throwBadInput(name_, "", fmt::format("\"{}\"", sqlite3_errmsg(base)),
                    phrase("a readable file"));
    }
    sqlite3_db_config(base, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(base, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_limit(base, SQLITE_LIMIT_LENGTH, kMostValueBytes);
  }

  void list(const std::stop_token& stop) {
    // A view could be made to compute without end.
    Statement tables(base_.get(),
                     "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name IN "
                     "('topics', 'messages') AND sql NOT LIKE 'CREATE VIRTUAL%'",
                     name_);
    if (!tables.next() || tables.number(0) != 2) {
      throwBadInput(name_, "", phrase("other tables"),
                    phrase("the tables of a ROS 2 bag: topics, messages"));
    }
    Statement topics(base_.get(), "SELECT id, name, type, serialization_format FROM topics", name_);
    while (topics.next()) {
      const auto encoding =
          topics.bytes(3) == "cdr" ? MessageEncoding::Cdr : MessageEncoding::Other;
      topic_of_[topics.number(0)] =
          topicOf(std::string(topics.bytes(1)), std::string(topics.bytes(2)), encoding);
    }
    Statement times(base_.get(), "SELECT topic_id, timestamp FROM messages", name_);
    while (times.next()) {
      throwIfStopped(stop);
      const auto topic = topic_of_.find(times.number(0));
      if (topic != topic_of_.end()) {
        count(topic->second, 1e-9 * static_cast<double>(times.number(1)));
      }
    }
  }

  struct Close {
    void operator()(sqlite3* base) const { sqlite3_close_v2(base); }
  };
  std::string name_;
  std::unique_ptr<sqlite3, Close> base_;
  std::map<std::int64_t, std::size_t> topic_of_;
};

}  // namespace

std::unique_ptr<Bag> openSqliteBag(const std::filesystem::path& path, const std::stop_token& stop) {
  return std::make_unique<SqliteBag>(path, stop);
}

}  // namespace handmap
