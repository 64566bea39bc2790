#include "core/logs/table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include <fmt/ranges.h>

#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

namespace {

constexpr std::size_t kMostNumbers = 64u << 20;
constexpr std::size_t kMostColumns = 20'000;

std::string lowercase(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

char separatorOf(std::string_view line) {
  for (const char separator : {';', '\t', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ' ';
}

std::vector<std::string_view> fieldsOf(std::string_view line, char separator) {
  return separator == ' ' ? splitWords(line) : splitFields(line, separator);
}

/// Where fields are apart by something else, a comma is that of a decimal fraction.
std::optional<double> numberIn(std::string_view field, char separator) {
  if (const auto value = parseFinite(field)) return value;
  if (const auto comma = field.find(','); separator != ',' && comma != std::string_view::npos) {
    std::string plain(field);
    plain[comma] = '.';
    return parseFinite(plain);
  }
  const std::string word = lowercase(trimmed(field));
  const bool none = word.empty() || word == "nan" || word == "-nan" || word.ends_with("inf") ||
                    word == "infinity" || word == "none" || word == "null";
  return none ? std::optional(std::numeric_limits<double>::quiet_NaN()) : std::nullopt;
}

struct RoleNames {
  const char* role;
  std::vector<std::string_view> names;
};

/// Those of common programs, without units; of rostopic echo -p without "field.".
const std::vector<RoleNames>& roleNames() {
  static const std::vector<RoleNames> kNames{
      {"time", {"time", "t", "timestamp", "stamp", "%time", "seconds", "secs"}},
      {"scan", {"scan", "scan_id", "frame", "seq"}},
      {"x", {"x", "px", "pos_x", "pose_x", "odom_x", "pose.pose.position.x"}},
      {"y", {"y", "py", "pos_y", "pose_y", "odom_y", "pose.pose.position.y"}},
      {"z", {"z"}},
      {"w", {"w"}},
      {"heading",
       {"heading", "theta", "yaw", "th", "phi", "odom_theta", "odom_yaw", "pose_theta",
        "pose_yaw"}},
      {"qx", {"qx", "q_x", "pose.pose.orientation.x"}},
      {"qy", {"qy", "q_y", "pose.pose.orientation.y"}},
      {"qz", {"qz", "q_z", "pose.pose.orientation.z"}},
      {"qw", {"qw", "q_w", "pose.pose.orientation.w"}},
      {"angle_min", {"angle_min"}},
      {"angle_increment", {"angle_increment", "angle_step"}},
      {"range_max", {"range_max"}}};
  return kNames;
}

struct Unit {
  std::string_view ending;  ///< of a name
  double factor;
};

/// nullptr: the name tells none.
const Unit* unitIn(std::string_view name) {
  static constexpr Unit kUnits[] = {{"_ms", 1e-3}, {"_us", 1e-6}, {"_ns", 1e-9},
                                    {"_s", 1.0},   {"_mm", 1e-3}, {"_cm", 1e-2},
                                    {"_m", 1.0},   {"_rad", 1.0}, {"_deg", toRadians(1.0)}};
  const auto* found =
      std::ranges::find_if(kUnits, [&](const Unit& unit) { return name.ends_with(unit.ending); });
  return found == std::end(kUnits) ? nullptr : found;
}

/// range_0, ranges[12], r7, ranges0, 0 …
bool isRangeName(const std::string& name) {
  const std::size_t letters = name.find_first_of("0123456789");
  if (letters == std::string::npos || letters == 0) return false;
  const std::string word = name.substr(0, name.find_first_of("_[0123456789"));
  return word == "range" || word == "ranges" || word == "r" || word == "d" || word == "dist";
}

/// In lower case, and "X [mm]" or "x(mm)" as x_mm.
std::string plainName(const std::string& name) {
  std::string plain = lowercase(name);
  if (plain.starts_with("field.")) plain.erase(0, 6);
  const std::size_t bracket = plain.find_first_of("[(");
  if (bracket == std::string::npos || bracket == 0 || isRangeName(plain)) return plain;
  const std::size_t end = plain.find_first_of("])", bracket);
  const std::string unit = plain.substr(bracket + 1, end - bracket - 1);
  return std::string(trimmed(plain.substr(0, bracket))) + '_' + unit;
}

}  // namespace

Table parseTable(std::string_view content, const std::string& file, const std::stop_token& stop) {
  Table table;
  table.file = file;
  ContentLines lines(content);
  char separator = ',';
  while (const auto line = lines.next()) {
    throwIfStopped(stop);
    const bool first = table.names.empty();
    if (first) separator = separatorOf(line->text);
    const auto fields = fieldsOf(line->text, separator);
    const std::string place = phrase("line {}", line->number);
    if (first) {
      if (fields.size() > kMostColumns) {
        throwBadInput(file, place, phrase("{} columns", fields.size()),
                      phrase("at most {}", kMostColumns));
      }
      table.has_header = std::ranges::any_of(
          fields, [separator](std::string_view f) { return !numberIn(f, separator); });
      for (std::size_t i = 0; i < fields.size(); ++i) {
        table.names.push_back(table.has_header ? std::string(fields[i]) : std::to_string(i + 1));
      }
      if (table.has_header) continue;
    }
    if (fields.size() != table.width()) {
      throwBadInput(file, place, phrase("{} fields", fields.size()),
                    phrase("{}, as the lines before have", table.width()));
    }
    if (table.values.size() + fields.size() > kMostNumbers) {
      throwBadInput(file, place, phrase("more values"), phrase("at most {}", kMostNumbers));
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto value = numberIn(fields[i], separator);
      if (!value) {
        throwBadInput(file, fmt::format("{}: {}", place, table.names[i]),
                      fmt::format("\"{}\"", fields[i].substr(0, 40)), phrase("a number"));
      }
      table.values.push_back(*value);
    }
    table.lines.push_back(line->number);
  }
  if (table.rows() == 0) throwBadInput(file, "", phrase("no rows"), phrase("rows of numbers"));
  return table;
}

Columns::Columns(const Table& table, const LogOptions& options) : table_(table) {
  for (std::size_t i = 0; i < table.width(); ++i) {
    const std::string name = plainName(table.names[i]);
    const bool is_range = table.has_header && isRangeName(name);
    if (is_range) ranges_.push_back(i);
    const Unit* unit = unitIn(name);
    const auto bare = name.substr(0, name.size() - (unit == nullptr ? 0 : unit->ending.size()));
    bool known = is_range || !table.has_header;
    for (const auto& [role, names] : roleNames()) {
      if (std::ranges::find(names, bare) == names.end()) continue;
      columns_.try_emplace(role, i);
      known = true;
    }
    if (!known) unknown_.push_back(table.names[i]);
  }
  for (const auto& [role, column] : options.columns) {
    unknown_.clear();  // who tells one has seen them all
    const std::vector<std::size_t> which = told(role, column);
    if (role == "ranges") {
      ranges_ = which;
    } else {
      columns_[role] = which.front();
    }
  }
}

std::vector<std::size_t> Columns::told(const std::string& role, const std::string& column) const {
  const auto named = std::ranges::find(table_.names, column);
  if (named != table_.names.end()) {
    return {static_cast<std::size_t>(named - table_.names.begin())};
  }
  const std::size_t dash = column.find('-');
  const auto first = parseInteger(column.substr(0, dash));
  const auto last =
      dash == std::string::npos ? first : parseInteger(std::string_view(column).substr(dash + 1));
  const auto width = static_cast<std::int64_t>(table_.width());
  if (!first || !last || *first < 1 || *last < *first || *last > width) {
    const std::vector<std::string> some(
        table_.names.begin(),
        table_.names.begin() +
            static_cast<std::ptrdiff_t>(std::min<std::size_t>(12, table_.width())));
    throwBadInput("--columns", role, fmt::format("\"{}\"", column),
                  phrase("a column of {}: a number from 1 to {}, A-B, or one of {}", table_.file,
                         width, fmt::join(some, " ")));
  }
  std::vector<std::size_t> which;
  for (std::int64_t i = *first; i <= *last; ++i) which.push_back(static_cast<std::size_t>(i - 1));
  return which;
}

std::optional<std::size_t> Columns::of(const std::string& role) const {
  const auto found = columns_.find(role);
  return found == columns_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> Columns::unitOf(const std::string& role) const {
  const auto column = of(role);
  return column ? unitAt(*column) : std::nullopt;
}

std::optional<double> Columns::unitOfRanges() const {
  return ranges_.empty() ? std::nullopt : unitAt(ranges_.front());
}

std::optional<double> Columns::unitAt(std::size_t column) const {
  const std::string name = plainName(table_.names[column]);
  if (name == "%time") return 1e-9;  // of rostopic echo -p
  const Unit* unit = unitIn(name);
  return unit == nullptr ? std::nullopt : std::optional(unit->factor);
}

}  // namespace handmap
