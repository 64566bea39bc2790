#include "core/geodata/fleet_map.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/map/map_limits.h"
#include "core/map/underlay_fit.h"

namespace handmap {

namespace {

constexpr auto kFrameKey = "handmap:robot_map";
constexpr auto kLevel = "L1";
constexpr double kMostCells = 1e6;

std::optional<RobotFrame> frameOf(const Underlay& underlay) {
  const auto found = underlay.unknown.find(kFrameKey);
  if (found == underlay.unknown.end()) return std::nullopt;
  try {
    const nlohmann::json json = parseJson(found->second, kFrameKey);
    const JsonValue value(json, kFrameKey);
    const auto number = [&](const char* key, double most) {
      return value.at(key).number(-most, most);
    };
    return RobotFrame{{static_cast<int>(number("columns", kMostCells)),
                       static_cast<int>(number("rows", kMostCells))},
                      value.at("cell_m").positive(kMaxMetresPerPixel),
                      {number("x", kMaxCoordinate), number("y", kMaxCoordinate),
                       toRadians(number("heading_deg", 360.0))}};
  } catch (const Error&) {
    return std::nullopt;  // of somebody else
  }
}

std::string number(double metres) { return formatNumber(std::round(1e4 * metres) / 1e4); }

void writePoints(YAML::Emitter& out, const char* key, const std::vector<Vec2>& points) {
  out << YAML::Key << key << YAML::Value << YAML::BeginSeq;
  for (const Vec2& p : points) {
    out << YAML::Flow << YAML::BeginSeq << number(p.x()) << number(p.y()) << YAML::EndSeq;
  }
  out << YAML::EndSeq;
}

void writeVertex(YAML::Emitter& out, const Vec2& place, const std::string& name) {
  out << YAML::Flow << YAML::BeginSeq << number(place.x()) << number(place.y()) << 0
      << YAML::DoubleQuoted << name << YAML::EndSeq;
}

}  // namespace

void rememberFrame(const RobotFrame& frame, Underlay& underlay) {
  const nlohmann::json json = {
      {"columns", frame.cells[0]}, {"rows", frame.cells[1]},
      {"cell_m", frame.cell_m},    {"x", frame.origin.x},
      {"y", frame.origin.y},       {"heading_deg", toDegrees(frame.origin.heading)}};
  underlay.unknown[kFrameKey] = json.dump();
}

bool hasRobotMap(const Map& map) {
  return std::any_of(map.underlays.begin(), map.underlays.end(),
                     [](const Underlay& underlay) { return frameOf(underlay).has_value(); });
}

std::string formatBuildingYaml(const Map& map) {
  YAML::Emitter out;
  out << YAML::BeginMap;
  out << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted
      << (map.name.empty() ? "building" : map.name);
  out << YAML::Key << "coordinate_system" << YAML::Value << "cartesian_meters";
  out << YAML::Key << "levels" << YAML::Value << YAML::BeginMap;
  out << YAML::Key << kLevel << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "elevation" << YAML::Value << 0;
  out << YAML::Key << "vertices" << YAML::Value << YAML::BeginSeq;
  std::vector<std::array<std::size_t, 2>> walls;
  std::size_t count = 0;
  for (const Building& building : map.buildings) {
    const Polygon outline = building.footprint();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      writeVertex(out, outline[i], "");
      walls.push_back({count + i, count + (i + 1) % outline.size()});
    }
    count += outline.size();
  }
  for (const Landmark& landmark : map.landmarks) {
    writeVertex(out, landmark.position, landmark.name.empty() ? landmark.id : landmark.name);
  }
  out << YAML::EndSeq;
  out << YAML::Key << "walls" << YAML::Value << YAML::BeginSeq;
  for (const auto& [from, to] : walls) {
    out << YAML::Flow << YAML::BeginSeq << from << to << YAML::BeginMap << YAML::EndMap
        << YAML::EndSeq;
  }
  out << YAML::EndSeq;
  for (const char* none : {"doors", "fiducials", "floors", "lanes", "measurements", "models"}) {
    out << YAML::Key << none << YAML::Value << YAML::Flow << YAML::BeginSeq << YAML::EndSeq;
  }
  out << YAML::EndMap << YAML::EndMap;
  out << YAML::Key << "lifts" << YAML::Value << YAML::Flow << YAML::BeginMap << YAML::EndMap;
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

std::string formatReferenceCoordinates(const Map& map, const std::filesystem::path& file) {
  std::vector<Vec2> robot;
  std::vector<Vec2> here;
  int maps = 0;
  for (const Underlay& underlay : map.underlays) {
    const auto frame = frameOf(underlay);
    if (!frame) continue;
    ++maps;
    for (const Vec2& corner : {Vec2(0, 0), Vec2(0, 1), Vec2(1, 1), Vec2(1, 0)}) {
      const Vec2 cell = corner.cwiseProduct(Vec2(frame->cells[0], frame->cells[1]));
      robot.push_back(frame->origin.toOuter(frame->cell_m * cell));
      here.push_back(pointOf(underlay, {cell.x(), frame->cells[1] - cell.y()}));
    }
  }
  if (maps != 1) {
    throwBadInput(file.string(), "underlays", phrase("{} maps of robots", maps),
                  phrase("one, laid on the drawing"));
  }
  YAML::Emitter out;
  out << YAML::BeginMap << YAML::Key << "reference_coordinates" << YAML::Value << YAML::BeginMap
      << YAML::Key << kLevel << YAML::Value << YAML::BeginMap;
  writePoints(out, "rmf", here);
  writePoints(out, "robot", robot);
  out << YAML::EndMap << YAML::EndMap << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace handmap
