#include "drivers/foxglove/foxglove_messages.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace handmap {

namespace {

using nlohmann::json;

constexpr double kLine_m = 0.3;
constexpr int kLineStrip = 0;
constexpr int kDeleteAll = 1;

QByteArray textOf(const json& value) {
  return QByteArray::fromStdString(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

json timeOf(double time_s) {
  const double seconds = std::floor(std::max(time_s, 0.0));  // of Foxglove's none is negative
  return {{"sec", static_cast<std::uint32_t>(seconds)},
          {"nsec", static_cast<std::uint32_t>((std::max(time_s, 0.0) - seconds) * 1e9)}};
}

json vectorOf(double x, double y, double z) { return {{"x", x}, {"y", y}, {"z", z}}; }

json poseOf(const Pose2& pose) {
  json orientation = vectorOf(0.0, 0.0, std::sin(0.5 * pose.heading));
  orientation["w"] = std::cos(0.5 * pose.heading);
  return {{"position", vectorOf(pose.x, pose.y, 0.0)}, {"orientation", orientation}};
}

json numbers(std::initializer_list<const char*> names) {
  json properties = json::object();
  for (const char* name : names) properties[name] = {{"type", "number"}};
  return {{"type", "object"}, {"properties", properties}};
}

json timeSchema() {
  return {{"type", "object"},
          {"title", "time"},
          {"properties", {{"sec", {{"type", "integer"}}}, {"nsec", {{"type", "integer"}}}}}};
}

json poseSchema() {
  return {
      {"type", "object"},
      {"properties",
       {{"position", numbers({"x", "y", "z"})}, {"orientation", numbers({"x", "y", "z", "w"})}}}};
}

json listOf(const json& items) { return {{"type", "array"}, {"items", items}}; }

json lineSchema() {
  return {{"type", "object"},
          {"properties",
           {{"type", {{"type", "integer"}}},
            {"pose", poseSchema()},
            {"thickness", {{"type", "number"}}},
            {"scale_invariant", {{"type", "boolean"}}},
            {"points", listOf(numbers({"x", "y", "z"}))},
            {"color", numbers({"r", "g", "b", "a"})}}}};
}

}  // namespace

FoxgloveChannel poseChannel(std::uint32_t id, const QString& topic) {
  const json schema = {
      {"title", "foxglove.PoseInFrame"},
      {"type", "object"},
      {"properties",
       {{"timestamp", timeSchema()}, {"frame_id", {{"type", "string"}}}, {"pose", poseSchema()}}}};
  return {id, topic, QStringLiteral("foxglove.PoseInFrame"), QString::fromUtf8(textOf(schema))};
}

FoxgloveChannel sceneChannel(std::uint32_t id, const QString& topic) {
  const json entity = {{"type", "object"},
                       {"properties",
                        {{"timestamp", timeSchema()},
                         {"frame_id", {{"type", "string"}}},
                         {"id", {{"type", "string"}}},
                         {"lines", listOf(lineSchema())}}}};
  const json deletion = {{"type", "object"},
                         {"properties",
                          {{"timestamp", timeSchema()},
                           {"type", {{"type", "integer"}}},
                           {"id", {{"type", "string"}}}}}};
  const json schema = {
      {"title", "foxglove.SceneUpdate"},
      {"type", "object"},
      {"properties", {{"deletions", listOf(deletion)}, {"entities", listOf(entity)}}}};
  return {id, topic, QStringLiteral("foxglove.SceneUpdate"), QString::fromUtf8(textOf(schema))};
}

QByteArray poseInFrame(double time_s, const Pose2& pose) {
  return textOf({{"timestamp", timeOf(time_s)}, {"frame_id", "map"}, {"pose", poseOf(pose)}});
}

QByteArray sceneUpdate(double time_s, const Map& map) {
  json entities = json::array();
  for (const Building& building : map.buildings) {
    const Polygon footprint = building.footprint();
    json points = json::array();
    for (const Vec2& corner : footprint) points.push_back(vectorOf(corner.x(), corner.y(), 0.0));
    points.push_back(points.front());
    const json line = {
        {"type", kLineStrip},      {"pose", poseOf({})},
        {"thickness", kLine_m},    {"scale_invariant", false},
        {"points", points},        {"color", {{"r", 0.0}, {"g", 0.35}, {"b", 0.85}, {"a", 1.0}}},
        {"colors", json::array()}, {"indices", json::array()}};
    entities.push_back({{"timestamp", timeOf(time_s)},
                        {"frame_id", "map"},
                        {"id", building.id},
                        {"lifetime", timeOf(0.0)},
                        {"frame_locked", false},
                        {"metadata", json::array()},
                        {"arrows", json::array()},
                        {"cubes", json::array()},
                        {"spheres", json::array()},
                        {"cylinders", json::array()},
                        {"lines", json::array({line})},
                        {"triangles", json::array()},
                        {"texts", json::array()},
                        {"models", json::array()}});
  }
  const json deletion = {{"timestamp", timeOf(time_s)}, {"type", kDeleteAll}, {"id", ""}};
  return textOf({{"deletions", json::array({deletion})}, {"entities", entities}});
}

}  // namespace handmap
