#include "drivers/scanner/scip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.h"

namespace handmap {

namespace {

constexpr char kZero = 0x30;
constexpr int kMostLines = 200;  // 1440 steps of three characters are 68 lines
constexpr std::size_t kStampCharacters = 4;
constexpr std::size_t kRangeCharacters = 3;
constexpr std::uint32_t kStampMask = 0xffffff;

std::optional<int> parameter(std::string_view line, std::string_view key, int low, int high) {
  if (!line.starts_with(key)) return std::nullopt;
  line.remove_prefix(key.size());
  if (line.ends_with(';')) line.remove_suffix(1);
  const auto value = parseInteger(line);
  if (!value || *value < low || *value > high) return std::nullopt;
  return static_cast<int>(*value);
}

}  // namespace

char scipSum(std::string_view text) {
  unsigned sum = 0;
  for (const char c : text) sum += static_cast<unsigned char>(c);
  return static_cast<char>((sum & 0x3fU) + kZero);
}

std::optional<std::uint32_t> scipDecode(std::string_view characters) {
  std::uint32_t value = 0;
  for (const char c : characters) {
    const int bits = c - kZero;
    if (bits < 0 || bits > 0x3f) return std::nullopt;
    value = (value << 6U) | static_cast<std::uint32_t>(bits);
  }
  return value;
}

std::string scipEncode(std::uint32_t value, int characters) {
  std::string text;
  for (int i = characters - 1; i >= 0; --i) {
    text += static_cast<char>(((value >> (6 * i)) & 0x3fU) + kZero);
  }
  return text;
}

std::optional<ScipAnswer> ScipReader::take(std::string_view line) {
  if (!line.empty()) {
    bad_ = bad_ || ++lines_ > kMostLines;
    if (lines_ == 1) {
      answer_.echo = line;
    } else if (!bad_) {
      bad_ = lines_ == 2 ? !takeStatus(line) : !takeData(line);
    }
    return std::nullopt;
  }
  const bool whole = !bad_ && lines_ >= 2;
  if (lines_ > 0 && !whole) ++damaged_;
  ScipAnswer answer = std::move(answer_);
  clear();
  if (!whole) return std::nullopt;
  return answer;
}

void ScipReader::clear() {
  answer_ = {};
  lines_ = 0;
  bad_ = false;
}

// Two characters and their sum. The older form of some firmwares has no sum.
bool ScipReader::takeStatus(std::string_view line) {
  answer_.status = line.substr(0, 2);
  return line.size() == 2 || (line.size() == 3 && scipSum(line.substr(0, 2)) == line[2]);
}

bool ScipReader::takeData(std::string_view line) {
  if (line.size() < 2) return false;
  std::string_view text = line.substr(0, line.size() - 1);
  const char sum = line.back();
  // Where the text is for people, a semicolon stands before the sum and does not count.
  if (text.ends_with(';') && scipSum(text.substr(0, text.size() - 1)) == sum) {
    text.remove_suffix(1);
  } else if (scipSum(text) != sum) {
    return false;
  }
  answer_.lines.emplace_back(text);
  return true;
}

std::optional<ScipParameters> parseScipParameters(const ScipAnswer& answer) {
  ScipParameters parameters;
  int found = 0;
  const auto read = [&](const std::string& line, std::string_view key, int low, int high,
                        int& value) {
    const auto read_value = parameter(line, key, low, high);
    if (read_value) value = *read_value;
    found += read_value ? 1 : 0;
  };
  for (const std::string& line : answer.lines) {
    if (line.starts_with("MODL:")) parameters.model = line.substr(5, 60);
    read(line, "DMIN:", 0, 10'000, parameters.least_mm);
    read(line, "DMAX:", 100, 262'143, parameters.most_mm);
    read(line, "ARES:", 4, 100'000, parameters.steps_a_turn);
    read(line, "AMIN:", 0, 9'999, parameters.first_step);
    read(line, "AMAX:", 0, 9'999, parameters.last_step);
    read(line, "AFRT:", 0, 9'999, parameters.front_step);
    read(line, "SCAN:", 1, 60'000, parameters.turns_a_minute);
  }
  const bool ordered = parameters.first_step < parameters.last_step &&
                       parameters.last_step - parameters.first_step <= parameters.steps_a_turn;
  if (found != 7 || !ordered || parameters.least_mm >= parameters.most_mm) return std::nullopt;
  return parameters;
}

std::optional<ScipScan> parseScipScan(const ScipAnswer& answer, const ScipParameters& parameters) {
  if (answer.status != "99" || answer.lines.empty()) return std::nullopt;
  const auto stamp = scipDecode(answer.lines.front());
  if (!stamp || answer.lines.front().size() != kStampCharacters) return std::nullopt;
  ScipScan scan;
  scan.stamp_ms = *stamp & kStampMask;
  std::string data;
  for (std::size_t i = 1; i < answer.lines.size(); ++i) data += answer.lines[i];
  const auto steps = static_cast<std::size_t>(parameters.last_step - parameters.first_step + 1);
  if (data.size() != steps * kRangeCharacters) return std::nullopt;
  scan.ranges_mm.reserve(steps);
  for (std::size_t i = 0; i < data.size(); i += kRangeCharacters) {
    const auto range = scipDecode(std::string_view(data).substr(i, kRangeCharacters));
    if (!range) return std::nullopt;
    scan.ranges_mm.push_back(static_cast<int>(*range));
  }
  return scan;
}

std::vector<RangePoint> scipPoints(const ScipScan& scan, const ScipParameters& parameters) {
  std::vector<RangePoint> points;
  points.reserve(scan.ranges_mm.size());
  const double step_rad = 2.0 * kPi / parameters.steps_a_turn;
  for (std::size_t i = 0; i < scan.ranges_mm.size(); ++i) {
    const int range_mm = scan.ranges_mm[i];
    if (range_mm == 0 || range_mm > parameters.most_mm) continue;  // nothing came back
    const int step = parameters.first_step + static_cast<int>(i) - parameters.front_step;
    if (range_mm < parameters.least_mm) {  // the code of an error
      points.push_back(notMeasured(step * step_rad, 0.0F));
      continue;
    }
    const Vec2 point = range_mm * 1e-3 * unitVector(step * step_rad);
    points.push_back({static_cast<float>(point.x()), static_cast<float>(point.y()), 0.0F, 1.0F});
  }
  return points;
}

double ScipClock::seconds(std::uint32_t stamp_ms) {
  if (begun_) {
    // The shorter way around: a stamp may also be a little before the last one.
    const std::int64_t turn = std::int64_t{kStampMask} + 1;
    std::int64_t passed = (std::int64_t{stamp_ms} - std::int64_t{last_ms_}) % turn;
    if (passed < -turn / 2) passed += turn;
    if (passed >= turn / 2) passed -= turn;
    passed_ms_ += passed;
  }
  begun_ = true;
  last_ms_ = stamp_ms;
  return static_cast<double>(passed_ms_) * 1e-3;
}

}  // namespace handmap
