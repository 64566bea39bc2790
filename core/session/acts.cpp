#include "core/session/acts.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

#include <fcntl.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/map/map_limits.h"
#include "core/recording/time_limits.h"

namespace handmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMaxBytes = 16U << 20U;

struct Name {
  Act::Kind kind;
  const char* text;
};
constexpr Name kNames[] = {{Act::Kind::RobotIsHere, "robot_is_here"},
                           {Act::Kind::BuildingIsRight, "building_is_right"},
                           {Act::Kind::BuildingIsNotThere, "building_is_not_there"},
                           {Act::Kind::ForgetPoses, "forget_poses"}};

double coordinate(const JsonValue& value) { return value.number(-kMaxCoordinate, kMaxCoordinate); }

double heading(const JsonValue& json) {
  return toRadians(json.at("heading_deg").number(-kMaxHeadingDeg, kMaxHeadingDeg));
}

Act::Kind kindOf(const JsonValue& value) {
  const std::string text = value.text(kMaxTextBytes);
  for (const Name& name : kNames) {
    if (text == name.text) return name.kind;
  }
  value.fail(phrase("{}, {}, {} or {}", "robot_is_here", "building_is_right",
                    "building_is_not_there", "forget_poses"));
}

std::variant<Rectangle, Polygon> shapeOf(const JsonValue& json) {
  const auto vertices = json.find("vertices");
  if (!vertices) {
    return Rectangle{{coordinate(json.at("x")), coordinate(json.at("y"))},
                     json.at("width").positive(kMaxSize),
                     json.at("depth").positive(kMaxSize),
                     heading(json)};
  }
  Polygon polygon;
  for (const JsonValue& corner : vertices->items(kMaxPolygonVertices)) {
    const auto numbers = corner.items(2);
    if (numbers.size() != 2) corner.fail("[x, y]");
    polygon.emplace_back(coordinate(numbers[0]), coordinate(numbers[1]));
  }
  if (polygon.size() < 3) vertices->fail(phrase("at least 3 vertices"));
  if (!isSimple(polygon)) vertices->fail(phrase("an outline that does not meet itself"));
  if (signedArea(polygon) < 0.0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

Act actOf(const JsonValue& json) {
  Act act;
  act.time_s = json.at("time_s").number(-kMaxTime_s, kMaxTime_s);
  act.kind = kindOf(json.at("act"));
  switch (act.kind) {
    case Act::Kind::RobotIsHere:
      act.pose = {coordinate(json.at("x")), coordinate(json.at("y")), heading(json)};
      break;
    case Act::Kind::BuildingIsRight:
      act.shape = shapeOf(json);
      [[fallthrough]];
    case Act::Kind::BuildingIsNotThere:
      act.building = json.at("building").text(kMaxTextBytes);
      break;
    case Act::Kind::ForgetPoses:
      break;
  }
  return act;
}

void addShape(const Act& act, Json& json) {
  if (const auto* box = std::get_if<Rectangle>(&act.shape)) {
    json["x"] = box->centre.x();
    json["y"] = box->centre.y();
    json["width"] = box->width;
    json["depth"] = box->depth;
    json["heading_deg"] = toDegrees(box->heading);
    return;
  }
  for (const Vec2& corner : std::get<Polygon>(act.shape)) {
    json["vertices"].push_back({corner.x(), corner.y()});
  }
}

}  // namespace

std::string formatAct(const Act& act) {
  Json json{{"time_s", act.time_s}};
  for (const Name& name : kNames) {
    if (name.kind == act.kind) json["act"] = name.text;
  }
  switch (act.kind) {
    case Act::Kind::RobotIsHere:
      json["x"] = act.pose.x;
      json["y"] = act.pose.y;
      json["heading_deg"] = toDegrees(act.pose.heading);
      break;
    case Act::Kind::BuildingIsRight:
      json["building"] = act.building;
      addShape(act, json);
      break;
    case Act::Kind::BuildingIsNotThere:
      json["building"] = act.building;
      break;
    case Act::Kind::ForgetPoses:
      break;
  }
  return json.dump() + "\n";
}

std::vector<Act> readActs(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kActsFile;
  if (!fileExists(path)) return {};
  std::string content = readFile(path, kMaxBytes);
  content.resize(content.rfind('\n') == std::string::npos ? 0 : content.rfind('\n') + 1);
  std::vector<Act> acts;
  ContentLines lines(content);
  while (const auto line = lines.next()) {
    const std::string source = path.string() + ": " + phrase("line {}", line->number);
    const auto parsed = parseJson(line->text, source);
    acts.push_back(actOf(JsonValue(parsed, source)));
  }
  return acts;
}

void appendAct(const std::filesystem::path& folder, const Act& act) {
  const std::filesystem::path path = folder / kActsFile;
  const std::string line = formatAct(act);
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  const bool written =
      file >= 0 && ::write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size()) &&
      ::fsync(file) == 0;
  const int reason = errno;
  if (file >= 0) ::close(file);
  if (!written) {
    throw Error(ErrorCode::RunFailed,
                phrase("{}: cannot be written: {}", path.string(), std::strerror(reason)));
  }
}

void writeActs(const std::filesystem::path& folder, const std::vector<Act>& acts) {
  std::string content;
  for (const Act& act : acts) content += formatAct(act);
  writeFileAtomically(folder / kActsFile, content);
}

}  // namespace handmap
