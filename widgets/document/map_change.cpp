#include "widgets/document/map_change.h"

#include <QFileInfo>
#include <QObject>
#include <string>
#include <unordered_set>

namespace handmap {

namespace {
constexpr QLatin1String kPictureKey("@picture");
}  // namespace

QString pictureKey(std::size_t place) { return kPictureKey + QString::number(place); }

std::optional<std::size_t> pictureIndex(const QString& key) {
  if (!key.startsWith(kPictureKey)) return std::nullopt;
  bool is_number = false;
  const qulonglong place = QStringView(key).mid(kPictureKey.size()).toULongLong(&is_number);
  return is_number ? std::optional(static_cast<std::size_t>(place)) : std::nullopt;
}

Building moved(Building building, const Vec2& offset) {
  if (auto* rectangle = std::get_if<Rectangle>(&building.shape))
    rectangle->centre += offset;
  else
    for (Vec2& vertex : std::get<Polygon>(building.shape)) vertex += offset;
  return building;
}

Bounds boundsOf(const Building& building) {
  const auto* box = std::get_if<Rectangle>(&building.shape);
  if (!box) return boundsOf(std::get<Polygon>(building.shape));
  const Vec2 along = unitVector(box->heading).cwiseAbs();
  const Vec2 half(along.x() * box->width + along.y() * box->depth,
                  along.y() * box->width + along.x() * box->depth);
  return {box->centre - half / 2.0, box->centre + half / 2.0};
}

QStringList allKeys(const Map& map) {
  QStringList keys;
  for (const Building& building : map.buildings) keys << QString::fromStdString(building.id);
  for (const Landmark& landmark : map.landmarks) keys << QString::fromStdString(landmark.id);
  if (map.start) keys << kStartKey;
  if (!map.route.empty()) keys << kRouteKey;
  return keys;
}

MapChange selected(const Map& map, const QStringList& keys) {
  std::unordered_set<std::string> wanted;
  for (const QString& key : keys) wanted.insert(key.toStdString());
  MapChange objects;
  for (const Building& building : map.buildings)
    if (wanted.contains(building.id)) objects.buildings.push_back(building);
  for (const Landmark& landmark : map.landmarks)
    if (wanted.contains(landmark.id)) objects.landmarks.push_back(landmark);
  if (keys.contains(kStartKey)) objects.start = map.start;
  if (keys.contains(kRouteKey)) objects.route = map.route;
  return objects;
}

bool isLocked(const Map& map, const Building& building) {
  const LayerStates& layers = map.layers;
  return building.flags.locked || stateOf(layers, DrawingLayer::Buildings).locked;
}

MapChange movable(const Map& map, const QStringList& keys) {
  MapChange objects = selected(map, keys);
  std::erase_if(objects.buildings,
                [&](const Building& building) { return isLocked(map, building); });
  std::erase_if(objects.landmarks, [](const Landmark& landmark) { return landmark.flags.locked; });
  const LayerStates& layers = map.layers;
  if (stateOf(layers, DrawingLayer::Landmarks).locked) objects.landmarks.clear();
  if (stateOf(layers, DrawingLayer::Start).locked) objects.start.reset();
  if (stateOf(layers, DrawingLayer::Route).locked) objects.route.reset();
  return objects;
}

QStringList unlocked(const Map& map, const QStringList& keys) {
  const MapChange free = movable(map, keys);
  QStringList left;
  for (const Building& building : free.buildings) left << QString::fromStdString(building.id);
  for (const Landmark& landmark : free.landmarks) left << QString::fromStdString(landmark.id);
  if (free.start) left << kStartKey;
  if (free.route) left << kRouteKey;
  for (const QString& key : keys) {
    const auto place = pictureIndex(key);
    if (place && *place < map.underlays.size() && !map.underlays[*place].flags.locked) left << key;
  }
  return left;
}

MapChange moved(MapChange objects, const Vec2& offset) {
  for (Building& building : objects.buildings) building = moved(std::move(building), offset);
  for (Landmark& landmark : objects.landmarks) landmark.position += offset;
  if (objects.start) {
    objects.start->x += offset.x();
    objects.start->y += offset.y();
  }
  if (objects.route)
    for (Vec2& point : *objects.route) point += offset;
  return objects;
}

QString displayName(const Map& map, const QString& key) {
  if (key == kStartKey) return QObject::tr("Start");
  if (key == kRouteKey) return QObject::tr("Route");
  if (const auto place = pictureIndex(key); place && *place < map.underlays.size())
    return QFileInfo(QString::fromStdString(map.underlays[*place].image)).fileName();
  const MapChange objects = selected(map, {key});
  const std::string name = !objects.buildings.empty()   ? objects.buildings.front().name
                           : !objects.landmarks.empty() ? objects.landmarks.front().name
                                                        : std::string();
  return name.empty() ? key : QStringLiteral("%1 (%2)").arg(QString::fromStdString(name), key);
}

std::optional<Bounds> boundsOf(const Map& map, const QString& key) {
  std::vector<Vec2> points;
  const auto wanted = [&](const auto& item) {
    return key.isEmpty() || QString::fromStdString(item.id) == key;
  };
  for (const Building& building : map.buildings) {
    if (!wanted(building)) continue;
    const Polygon footprint = building.footprint();
    points.insert(points.end(), footprint.begin(), footprint.end());
  }
  for (const Landmark& landmark : map.landmarks)
    if (wanted(landmark)) points.push_back(landmark.position);
  if (map.start && (key.isEmpty() || key == kStartKey)) points.push_back(map.start->position());
  if (key.isEmpty() || key == kRouteKey)
    points.insert(points.end(), map.route.begin(), map.route.end());
  if (points.empty()) return std::nullopt;
  return boundsOf(points);
}

}  // namespace handmap
