#include "widgets/document/map_change.h"

#include <QFileInfo>
#include <QObject>
#include <QSet>

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

MapChange selected(const Map& map, const QStringList& keys) {
  const QSet<QString> wanted(keys.begin(), keys.end());
  MapChange objects;
  for (const Building& building : map.buildings)
    if (wanted.contains(QString::fromStdString(building.id))) objects.buildings.push_back(building);
  for (const Landmark& landmark : map.landmarks)
    if (wanted.contains(QString::fromStdString(landmark.id))) objects.landmarks.push_back(landmark);
  if (wanted.contains(kStartKey)) objects.start = map.start;
  if (wanted.contains(kRouteKey)) objects.route = map.route;
  return objects;
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
