// Random commands of every kind, as a person might give them.
#pragma once

#include "core/base/random.h"
#include "tests/widgets/tool_events.h"
#include "widgets/editing/arranging.h"
#include "widgets/editing/clipboard.h"
#include "widgets/tools/corner_handles.h"
#include "widgets/tools/select_tool.h"

namespace handmap {

inline Vec2 somewhere(RandomStream& random) {
  return roundedTo({random.uniform(-200.0, 200.0), random.uniform(-200.0, 200.0)}, 0.01);
}

inline Building house(RandomStream& random) {
  Building building;
  const Vec2 at = somewhere(random);
  if (random.uniform() < 0.5) {
    building.shape = Rectangle{at, random.uniform(5.0, 40.0), random.uniform(5.0, 20.0),
                               random.uniform(-kPi, kPi)};
  } else {
    Polygon l_shape = {{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 16}, {0, 16}};
    for (Vec2& corner : l_shape) corner += at;
    building.shape = l_shape;
  }
  return building;
}

inline void selectSome(MapDocument& document, RandomStream& random) {
  QStringList keys;
  const QStringList all = allKeys(document.map());
  for (int i = 0; i < 4 && !all.isEmpty(); ++i) keys << all[random.index(int(all.size()))];
  document.setSelection(keys);
}

inline void changeCorner(MapDocument& document, RandomStream& random) {
  document.setSelection(document.selection().mid(0, 1));
  SelectTool tool(document);
  key(tool, Qt::Key_Return);
  for (int i = random.index(6); i > 0; --i) key(tool, Qt::Key_Tab);
  const int what = random.index(4);
  if (what == 0)
    tool.addCornerBehindChosen();
  else if (what == 1)
    tool.removeChosenCorner();
  else
    key(tool, what == 2 ? Qt::Key_Right : Qt::Key_Up, Qt::ShiftModifier);
}

inline void arrange(MapDocument& document, RandomStream& random) {
  const Map& map = document.map();
  const QStringList keys = document.selection();
  switch (random.index(6)) {
    case 0:
      return document.apply(aligned(map, keys, static_cast<Alignment>(random.index(6))), "Align");
    case 1:
      return document.apply(distributed(map, keys, random.index(2) ? Along::X : Along::Y),
                            "Distribute");
    case 2:
      return document.apply(squaredUp(map, keys), "Square");
    case 3:
      return document.apply(madeParallel(map, keys), "Parallel");
    case 4:
      return document.apply(asPolygons(map, keys), "Polygon");
    default:
      return document.apply(lockToggled(map, keys), "Lock");
  }
}

inline void editAtRandom(MapDocument& document, RandomStream& random) {
  selectSome(document, random);
  const Map& map = document.map();
  const QStringList keys = document.selection();
  switch (random.index(13)) {
    case 0:
    case 1:
      document.addBuilding(house(random));
      break;
    case 2:
      document.apply(moved(movable(map, keys), somewhere(random)), "Move", random.index(2) == 0);
      break;
    case 3:
      document.add(copiesFor(map, moved(objectsOf(*clipboardData(map, keys)), {3.0, -3.0})),
                   "Paste");
      break;
    case 4:
      document.remove(keys.mid(0, 2));
      break;
    case 5:
      if (!keys.isEmpty()) document.rename(keys[0], QString::number(random.index(1000)));
      break;
    case 6:
      changeCorner(document, random);
      break;
    case 7: {
      std::vector<Vec2> route = map.route;
      route.push_back(somewhere(random));
      if (random.index(2) == 0)
        document.setRoute(route);
      else
        document.setStart(Pose2{route[0].x(), route[0].y(), random.uniform(-kPi, kPi)});
      break;
    }
    case 8: {
      Landmark landmark;
      landmark.position = somewhere(random);
      document.addLandmark(landmark);
      break;
    }
    case 9: {
      LayerStates layers = map.layers;
      layers[static_cast<std::size_t>(random.index(int(layers.size())))].hidden =
          random.index(2) == 0;
      document.setLayers(layers, "Layer");
      break;
    }
    case 10: {
      if (map.buildings.empty()) break;
      Building other =
          map.buildings[static_cast<std::size_t>(random.index(int(map.buildings.size())))];
      other.flags.hidden = random.index(4) == 0;
      other.may_not_exist = random.index(4) == 0;
      other.name = std::to_string(random.index(100));
      other.uncertainty = Uncertainty{random.uniform(0.5, 5.0), random.uniform(0.5, 5.0)};
      document.changeBuilding(QString::fromStdString(other.id), other, "Say", random.index(2) == 0);
      break;
    }
    case 11:
      if (random.index(2) == 0)
        document.setUncertainty({random.uniform(0.5, 5.0), random.uniform(0.5, 5.0)});
      else
        document.setStartUncertainty(StartUncertainty{random.uniform(0.5, 5.0), 0.1});
      break;
    default:
      arrange(document, random);
  }
}

}  // namespace handmap
