#include "widgets/editing/clipboard.h"

#include <QObject>
#include <unordered_set>

#include "core/base/error.h"
#include "core/map/certainty.h"
#include "core/map/map_io.h"
#include "core/map/map_limits.h"

namespace handmap {

namespace {

constexpr auto kMimeType = "application/vnd.handmap+json";

Map mapOf(const MapChange& objects) {
  Map map;
  map.buildings = objects.buildings;
  map.landmarks = objects.landmarks;
  map.start = objects.start;
  map.route = objects.route.value_or(std::vector<Vec2>());
  return map;
}

}  // namespace

std::unique_ptr<QMimeData> clipboardData(const Map& map, const QStringList& keys) {
  const QByteArray json = QByteArray::fromStdString(formatMap(mapOf(selected(map, keys))));
  auto data = std::make_unique<QMimeData>();
  data->setData(QLatin1String(kMimeType), json);
  data->setText(QString::fromUtf8(json));
  return data;
}

bool mayHoldObjects(const QMimeData& data) {
  return data.hasFormat(QLatin1String(kMimeType)) || data.hasText();
}

MapChange objectsOf(const QMimeData& data) {
  const QByteArray json = data.hasFormat(QLatin1String(kMimeType))
                              ? data.data(QLatin1String(kMimeType))
                              : data.text().toUtf8();
  if (static_cast<std::uintmax_t>(json.size()) > kMaxMapBytes)
    throw Error(ErrorCode::BadInput,
                QObject::tr("the clipboard holds too much for a drawing").toStdString());
  Map map = parseMap(json.toStdString(), QObject::tr("clipboard").toStdString());
  MapChange objects{std::move(map.buildings), std::move(map.landmarks), map.start};
  if (!map.route.empty()) objects.route = std::move(map.route);
  return objects;
}

MapChange copiesFor(const Map& map, MapChange objects) {
  std::unordered_set<std::string> names;
  for (const Building& building : map.buildings) names.insert(building.name);
  for (const Landmark& landmark : map.landmarks) names.insert(landmark.name);
  for (Building& building : objects.buildings) {
    building.estimate.reset();
    forgetCertainty(building);
    if (names.contains(building.name)) building.name.clear();
  }
  for (Landmark& landmark : objects.landmarks)
    if (names.contains(landmark.name)) landmark.name.clear();
  return objects;
}

MapChange centredAt(MapChange objects, const Vec2& middle) {
  const auto bounds = boundsOf(mapOf(objects));
  if (!bounds) return objects;
  const Vec2 offset = middle - (bounds->low + bounds->high) / 2.0;
  // Whole centimetres keep tidy numbers tidy.
  return moved(std::move(objects), (offset * 100.0).array().round() / 100.0);
}

}  // namespace handmap
