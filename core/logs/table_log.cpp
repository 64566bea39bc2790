#include "core/logs/table_log.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/ranges.h>

#include "core/base/phrase.h"
#include "core/logs/raw_scans.h"

namespace handmap {

namespace {

constexpr std::size_t kLeastRanges = 8;
constexpr double kLeastPointsAScan = 4.0;  // rows that share a time: less are poses

double orZero(const Table& table, std::size_t row, const std::optional<std::size_t>& column) {
  return column ? table.at(row, *column) : 0.0;
}

std::vector<std::string> firstOf(const std::vector<std::string>& names) {
  const auto some = static_cast<std::ptrdiff_t>(std::min<std::size_t>(12, names.size()));
  return {names.begin(), names.begin() + some};
}

class TableLog {
 public:
  TableLog(const Table& table, const LogOptions& options)
      : table_(table), options_(options), columns_(tum(table, options)) {
    raw_.file = table.file;
    raw_.seconds = columns_.unitOf("time");
    raw_.pose_metres = columns_.unitOf("x");
    raw_.metres = hasRanges() ? columns_.unitOfRanges() : raw_.pose_metres;
    raw_.radians = columns_.unitOf("heading");
  }

  bool hasRanges() const { return columns_.ranges().size() >= kLeastRanges; }
  const std::vector<std::string>& unknown() const { return columns_.unknown(); }

  RawLog read() {
    const auto x = columns_.of("x");
    const auto y = columns_.of("y");
    if (hasRanges()) {
      readRanges();
      if (x && y) readPoses();
    } else if (x && y) {
      if (isOfPoints()) {
        readPoints();
      } else {
        readPoses();
      }
    } else {
      ask();
    }
    return std::move(raw_);
  }

 private:
  /// Eight columns without a header are poses in TUM form.
  static Columns tum(const Table& table, LogOptions options) {
    constexpr std::size_t kTum = 8;
    if (!table.has_header && table.width() == kTum && options.columns.empty()) {
      options.columns = {{"time", "1"}, {"x", "2"},  {"y", "3"},  {"z", "4"},
                         {"qx", "5"},   {"qy", "6"}, {"qz", "7"}, {"qw", "8"}};
    }
    return {table, options};
  }

  [[noreturn]] void ask() const {
    const std::vector<std::string> names = firstOf(table_.names);
    throw Question(
        "columns",
        phrase("{}: found the columns {}{}, expected to know which hold what", table_.file,
               fmt::join(names, " "), table_.width() > names.size() ? " …" : ""),
        phrase("ROLE=COLUMN,… as time=1,ranges=2-362 or time=t,x=px,y=py"));
  }

  double time(std::size_t row) const {
    if (const auto column = columns_.of("time")) return table_.at(row, *column);
    if (options_.rate_hz) return static_cast<double>(row) / *options_.rate_hz;
    throw Question("rate", phrase("{}: found no column of times, expected one", table_.file),
                   phrase("how many scans a second there are"));
  }

  void readRanges() {
    const auto first = columns_.of("angle_min");
    const auto step = columns_.of("angle_increment");
    if (first && step) raw_.angles = RayAngles{table_.at(0, *first), table_.at(0, *step)};
    if (const auto most = columns_.of("range_max")) raw_.most_range_m = table_.at(0, *most);
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      RawScan& scan = raw_.scans.emplace_back();
      scan.time = time(row);
      for (const std::size_t column : columns_.ranges()) {
        scan.ranges.push_back(table_.at(row, column));
      }
    }
  }

  /// By the column that numbers the scans, else by the time.
  std::size_t groupColumn() const {
    const auto scan = columns_.of("scan");
    return scan ? *scan : columns_.of("time").value_or(table_.width());
  }

  bool isOfPoints() const {
    const std::size_t group = groupColumn();
    const bool has_heading = columns_.of("heading") || columns_.of("qw");
    if (group == table_.width() || has_heading) return false;
    std::size_t groups = 0;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      groups += row == 0 || table_.at(row, group) != table_.at(row - 1, group) ? 1 : 0;
    }
    return static_cast<double>(table_.rows()) >= kLeastPointsAScan * static_cast<double>(groups);
  }

  void readPoints() {
    const std::size_t group = groupColumn();
    const auto z = columns_.of("z");
    const auto w = columns_.of("w");
    const bool has_time = columns_.of("time").has_value();
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      if (row == 0 || table_.at(row, group) != table_.at(row - 1, group)) {
        const std::size_t number = raw_.scans.size();
        raw_.scans.emplace_back().time = has_time ? time(row) : time(number);
      }
      const double weight = w ? table_.at(row, *w) : 1.0;
      raw_.scans.back().points.push_back(
          {static_cast<float>(table_.at(row, *columns_.of("x"))),
           static_cast<float>(table_.at(row, *columns_.of("y"))),
           static_cast<float>(orZero(table_, row, z)),
           static_cast<float>(weight >= 0.0 && weight <= 1.0 ? weight : 1.0)});
    }
  }

  double heading(std::size_t row) const {
    if (const auto column = columns_.of("heading")) return table_.at(row, *column);
    const auto qz = columns_.of("qz");
    const auto qw = columns_.of("qw");
    if (qz && qw) {
      const double x = orZero(table_, row, columns_.of("qx"));
      const double y = orZero(table_, row, columns_.of("qy"));
      const double z = table_.at(row, *qz);
      const double w = table_.at(row, *qw);
      return std::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z);
    }
    throw Question("columns",
                   phrase("{}: found x and y without a heading, expected one", table_.file),
                   phrase("heading=COLUMN, or qx=…,qy=…,qz=…,qw=…"));
  }

  void readPoses() {
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      raw_.poses.push_back({time(row), table_.at(row, *columns_.of("x")),
                            table_.at(row, *columns_.of("y")), heading(row)});
    }
    if (columns_.of("qw")) raw_.radians = 1.0;
  }

  const Table& table_;
  const LogOptions& options_;
  Columns columns_;
  RawLog raw_;
};

}  // namespace

void addTable(const Table& table, const LogOptions& options, Log& log) {
  TableLog reader(table, options);
  addRaw(reader.read(), options, log);
  if (const std::vector<std::string> names = firstOf(reader.unknown()); !names.empty()) {
    log.notes.push_back(phrase("{}: columns that nothing is made of: {}{}", table.file,
                               fmt::join(names, " "),
                               reader.unknown().size() > names.size() ? " …" : ""));
  }
}

}  // namespace handmap
