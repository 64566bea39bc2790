// Some objects of a map, changed: what a tool previews and a command then does.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/map/map.h"

namespace handmap {

/// Objects are named by keys: the id of a building or landmark, or one of these two, or that of a
/// picture.
inline constexpr QLatin1String kStartKey("@start");
inline constexpr QLatin1String kRouteKey("@route");

/// "@picture0": its place in the list of underlays.
QString pictureKey(std::size_t place);
std::optional<std::size_t> pictureIndex(const QString& key);  ///< nullopt: not that of a picture

/// Buildings and landmarks are found by their ids; what is not mentioned stays.
struct MapChange {
  std::vector<Building> buildings = {};
  std::vector<Landmark> landmarks = {};
  std::optional<Pose2> start = {};
  std::optional<std::vector<Vec2>> route = {};
  std::optional<std::vector<Underlay>> underlays = {};  ///< all of them

  bool isEmpty() const {
    return buildings.empty() && landmarks.empty() && !start && !route && !underlays;
  }
};

Building moved(Building building, const Vec2& offset);
Bounds boundsOf(const Building& building);

/// The keys of everything drawn, without pictures.
QStringList allKeys(const Map& map);
/// The objects of the map that `keys` names, as they are; without pictures.
MapChange selected(const Map& map, const QStringList& keys);
/// Whether it, or its layer, is locked: nobody changes it by hand.
bool isLocked(const Map& map, const Building& building);
/// Those of them that are not locked.
MapChange movable(const Map& map, const QStringList& keys);
/// The keys of those, and of pictures that are not locked.
QStringList unlocked(const Map& map, const QStringList& keys);
MapChange moved(MapChange objects, const Vec2& offset);

/// "Library (N1)", "Start", "Route".
QString displayName(const Map& map, const QString& key);

/// Low and high corner of what is drawn (of the one object when `key` is given); nullopt for
/// nothing. Underlays are left out: their size is not in the map.
std::optional<Bounds> boundsOf(const Map& map, const QString& key = {});

}  // namespace handmap
