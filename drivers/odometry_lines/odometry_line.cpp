#include "drivers/odometry_lines/odometry_line.h"

#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

namespace {

constexpr double kFarthest_m = 1e7;
constexpr double kMostTurned = 1e6;  // radians, of a yaw that is not wrapped
constexpr double kLatest_s = 1e12;

std::string source() { return phrase("odometry line"); }

OdometryLine made(double t, double x, double y, double yaw) {
  return {t, {x, y, normalizedAngle(yaw)}};
}

double field(std::string_view text, const char* name, double limit) {
  const std::optional<double> value = parseFinite(text);
  if (!value || std::abs(*value) > limit) {
    throwBadInput(source(), name, fmt::format("\"{}\"", text.substr(0, 40)),
                  phrase("a number within ±{:g}", limit));
  }
  return *value;
}

std::string_view withoutChecksum(std::string_view line) {
  const std::size_t star = line.rfind('*');
  if (star == std::string_view::npos) return line;
  unsigned sum = 0;
  for (const char byte : line.substr(0, star)) sum ^= static_cast<unsigned char>(byte);
  const std::string expected = fmt::format("{:02X}", sum);
  std::string found(line.substr(star + 1, 3));
  for (char& c : found) c = static_cast<char>(c >= 'a' && c <= 'f' ? c - 'a' + 'A' : c);
  if (found != expected) throwBadInput(source(), "", phrase("checksum {}", found), expected);
  return line.substr(0, star);
}

}  // namespace

bool asksToLook(std::string_view line) {
  line = trimmed(line);
  return line == "look" || line == R"({"look":true})";
}

OdometryLine parseOdometryLine(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with('{')) {
    const nlohmann::json json = parseJson(line, source());
    const JsonValue value(json, source());
    const auto number = [&](const char* key, double limit) {
      return value.at(key).number(-limit, limit);
    };
    return made(number("t", kLatest_s), number("x", kFarthest_m), number("y", kFarthest_m),
                number("yaw", kMostTurned));
  }
  const auto fields = splitFields(withoutChecksum(line), ',');
  if (fields.size() != 5 || fields[0] != "odom") {
    throwBadInput(source(), "", fmt::format("\"{}\"", line.substr(0, 60)),
                  phrase("{} or JSON", "odom,t,x,y,yaw"));
  }
  return made(field(fields[1], "t", kLatest_s), field(fields[2], "x", kFarthest_m),
              field(fields[3], "y", kFarthest_m), field(fields[4], "yaw", kMostTurned));
}

}  // namespace handmap
