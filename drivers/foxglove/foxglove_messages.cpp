#include "drivers/foxglove/foxglove_messages.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

namespace handmap {

namespace {

using nlohmann::json;

constexpr double kLine_m = 0.3;
constexpr int kLineStrip = 0;
constexpr int kDeleteAll = 1;
constexpr int kUint8 = 1;  // of Foxglove's numeric types
constexpr int kFloat32 = 7;
constexpr int kJpegQuality = 80;  // percent: to look at

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

json number() { return {{"type", "number"}}; }
json integer() { return {{"type", "integer"}}; }
json text() { return {{"type", "string"}}; }
json bytes() { return {{"type", "string"}, {"contentEncoding", "base64"}}; }
json object(const json& properties) { return {{"type", "object"}, {"properties", properties}}; }

json lineSchema() {
  return object({{"type", integer()},
                 {"pose", poseSchema()},
                 {"thickness", number()},
                 {"scale_invariant", {{"type", "boolean"}}},
                 {"points", listOf(numbers({"x", "y", "z"}))},
                 {"color", numbers({"r", "g", "b", "a"})}});
}

json sceneProperties() {
  const json entity = object({{"timestamp", timeSchema()},
                              {"frame_id", text()},
                              {"id", text()},
                              {"lines", listOf(lineSchema())}});
  const json deletion = object({{"timestamp", timeSchema()}, {"type", integer()}, {"id", text()}});
  return {{"deletions", listOf(deletion)}, {"entities", listOf(entity)}};
}

/// With what all others have.
json stamped(json properties) {
  properties["timestamp"] = timeSchema();
  properties["frame_id"] = text();
  return properties;
}

json fieldsSchema() {
  return listOf(object({{"name", text()}, {"offset", integer()}, {"type", integer()}}));
}

FoxgloveChannel channelOf(FoxgloveTopic topic, const char* name, const char* schema_name,
                          const json& properties) {
  json schema = object(properties);
  schema["title"] = schema_name;
  return {static_cast<std::uint32_t>(topic) + 1, QString::fromLatin1(name),
          QString::fromLatin1(schema_name), QString::fromUtf8(textOf(schema))};
}

json field(const char* name, int offset, int type) {
  return {{"name", name}, {"offset", offset}, {"type", type}};
}

template <typename Item>
std::string base64(const std::vector<Item>& items) {
  return QByteArray::fromRawData(reinterpret_cast<const char*>(items.data()),
                                 static_cast<qsizetype>(items.size() * sizeof(Item)))
      .toBase64()
      .toStdString();
}

}  // namespace

std::vector<FoxgloveChannel> foxgloveChannels() {
  using Topic = FoxgloveTopic;
  const json transform = {{"timestamp", timeSchema()},
                          {"parent_frame_id", text()},
                          {"child_frame_id", text()},
                          {"translation", numbers({"x", "y", "z"})},
                          {"rotation", numbers({"x", "y", "z", "w"})}};
  const json points = stamped({{"pose", poseSchema()},
                               {"point_stride", integer()},
                               {"fields", fieldsSchema()},
                               {"data", bytes()}});
  const json grid = stamped({{"pose", poseSchema()},
                             {"column_count", integer()},
                             {"cell_size", numbers({"x", "y"})},
                             {"row_stride", integer()},
                             {"cell_stride", integer()},
                             {"fields", fieldsSchema()},
                             {"data", bytes()}});
  return {
      channelOf(Topic::Pose, "/handmap/pose", "foxglove.PoseInFrame",
                stamped({{"pose", poseSchema()}})),
      channelOf(Topic::Buildings, "/handmap/map", "foxglove.SceneUpdate", sceneProperties()),
      channelOf(Topic::Transforms, "/tf", "foxglove.FrameTransform", transform),
      channelOf(Topic::Points, "/handmap/points", "foxglove.PointCloud", points),
      channelOf(Topic::Particles, "/handmap/particles", "foxglove.PosesInFrame",
                stamped({{"poses", listOf(poseSchema())}})),
      channelOf(Topic::Grid, "/handmap/grid", "foxglove.Grid", grid),
      channelOf(Topic::Image, "/handmap/image", "foxglove.CompressedImage",
                stamped({{"data", bytes()}, {"format", text()}})),
  };
}

QByteArray poseInFrame(double time_s, const Pose2& pose) {
  return textOf({{"timestamp", timeOf(time_s)}, {"frame_id", "map"}, {"pose", poseOf(pose)}});
}

QByteArray frameTransform(double time_s, const std::string& parent, const std::string& child,
                          const Pose2& pose) {
  const json placed = poseOf(pose);
  return textOf({{"timestamp", timeOf(time_s)},
                 {"parent_frame_id", parent},
                 {"child_frame_id", child},
                 {"translation", placed["position"]},
                 {"rotation", placed["orientation"]}});
}

QByteArray pointCloud(double time_s, const Pose2& pose, const std::vector<RangePoint>& points) {
  static_assert(sizeof(RangePoint) == 16);
  return textOf({{"timestamp", timeOf(time_s)},
                 {"frame_id", "map"},
                 {"pose", poseOf(pose)},
                 {"point_stride", sizeof(RangePoint)},
                 {"fields", json::array({field("x", 0, kFloat32), field("y", 4, kFloat32),
                                         field("z", 8, kFloat32), field("wall", 12, kFloat32)})},
                 {"data", base64(points)}});
}

QByteArray posesInFrame(double time_s, const std::vector<Pose2>& poses) {
  json all = json::array();
  for (const Pose2& pose : poses) all.push_back(poseOf(pose));
  return textOf({{"timestamp", timeOf(time_s)}, {"frame_id", "map"}, {"poses", all}});
}

QByteArray gridOf(double time_s, const OccupancyGrid& grid) {
  return textOf({{"timestamp", timeOf(time_s)},
                 {"frame_id", "map"},
                 {"pose", poseOf({grid.origin.x(), grid.origin.y(), 0.0})},
                 {"column_count", grid.columns},
                 {"cell_size", {{"x", grid.cell_m}, {"y", grid.cell_m}}},
                 {"row_stride", grid.columns},
                 {"cell_stride", 1},
                 {"fields", json::array({field("building", 0, kUint8)})},
                 {"data", base64(grid.cells)}});
}

QByteArray compressedImage(double time_s, const cv::Mat& image) {
  std::vector<unsigned char> file;
  cv::imencode(".jpg", image, file, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  return textOf({{"timestamp", timeOf(time_s)},
                 {"frame_id", "camera"},
                 {"data", base64(file)},
                 {"format", "jpeg"}});
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
