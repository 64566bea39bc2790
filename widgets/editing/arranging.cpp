#include "widgets/editing/arranging.h"

#include <QSet>
#include <algorithm>
#include <functional>
#include <limits>

#include "core/sketching/squaring.h"

namespace handmap {

namespace {

constexpr double kNearAxes = toRadians(10.0);

/// A building or a landmark among those that are arranged.
struct Part {
  Bounds bounds;
  bool locked = false;
  std::function<void(MapChange&, const Vec2&)> move;
};

std::vector<Part> partsOf(const Map& map, const QStringList& keys) {
  const MapChange objects = selected(map, keys);
  std::vector<Part> parts;
  for (const Building& building : objects.buildings)
    parts.push_back({boundsOf(building), isLocked(map, building),
                     [building](MapChange& change, const Vec2& offset) {
                       change.buildings.push_back(moved(building, offset));
                     }});
  for (const Landmark& landmark : objects.landmarks)
    parts.push_back({{landmark.position, landmark.position},
                     landmark.flags.locked,
                     [landmark](MapChange& change, const Vec2& offset) {
                       change.landmarks.push_back(landmark);
                       change.landmarks.back().position += offset;
                     }});
  return parts;
}

Vec2 middleOf(const Bounds& bounds) { return (bounds.low + bounds.high) / 2.0; }

Bounds aroundAll(const std::vector<Part>& parts) {
  Bounds all = parts.front().bounds;
  for (const Part& part : parts) {
    all.low = all.low.cwiseMin(part.bounds.low);
    all.high = all.high.cwiseMax(part.bounds.high);
  }
  return all;
}

Vec2 offsetTo(const Bounds& all, const Bounds& one, Alignment alignment) {
  switch (alignment) {
    case Alignment::Left:
      return {all.low.x() - one.low.x(), 0.0};
    case Alignment::Right:
      return {all.high.x() - one.high.x(), 0.0};
    case Alignment::Top:
      return {0.0, all.high.y() - one.high.y()};
    case Alignment::Bottom:
      return {0.0, all.low.y() - one.low.y()};
    case Alignment::CentreX:
      return {middleOf(all).x() - middleOf(one).x(), 0.0};
    case Alignment::CentreY:
      return {0.0, middleOf(all).y() - middleOf(one).y()};
  }
  return Vec2::Zero();
}

Building turnedBy(const Building& building, double angle) {
  Rectangle box = building.box();
  box.heading = normalizedAngle(box.heading + angle);
  return building.fitted(box);
}

double headingOf(const Building& building) {
  const auto* rectangle = std::get_if<Rectangle>(&building.shape);
  return rectangle ? rectangle->heading : commonHeading(std::get<Polygon>(building.shape));
}

/// A building that is not arranged, with its box.
using Other = std::pair<const Building*, Bounds>;

std::vector<Other> othersThan(const Map& map, const QStringList& keys) {
  const QSet<QString> arranged(keys.begin(), keys.end());
  std::vector<Other> others;
  for (const Building& building : map.buildings)
    if (!arranged.contains(QString::fromStdString(building.id)))
      others.emplace_back(&building, boundsOf(building));
  return others;
}

const Building* nearestOf(const std::vector<Other>& others, const Building& to) {
  const Building* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  const Bounds own = boundsOf(to);
  for (const auto& [other, box] : others) {
    // Between the boxes, and where they touch between the middles.
    const Vec2 gap = (box.low - own.high).cwiseMax(own.low - box.high).cwiseMax(0.0);
    const double distance = gap.norm() + 1e-3 * (middleOf(box) - middleOf(own)).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = other;
  }
  return nearest;
}

using MovePoint = std::function<Vec2(const Vec2& from_middle)>;

/// What is not locked, about the middle of the boxes of all; tidy numbers stay tidy.
MapChange transformed(const Map& map, const QStringList& keys, const MovePoint& move,
                      const std::function<double(double)>& turn) {
  MapChange change = movable(map, keys);
  const std::vector<Part> parts = partsOf(map, keys);
  if (parts.empty()) return {};
  const Vec2 middle = middleOf(aroundAll(parts));
  const auto point = [&](const Vec2& from) { return Vec2(middle + move(from - middle)); };
  for (Building& building : change.buildings) {
    if (auto* box = std::get_if<Rectangle>(&building.shape)) {
      box->centre = point(box->centre);
      box->heading = turn(box->heading);
      continue;
    }
    auto& outline = std::get<Polygon>(building.shape);
    std::ranges::transform(outline, outline.begin(), point);
    if (signedArea(outline) < 0.0) std::ranges::reverse(outline);
  }
  for (Landmark& landmark : change.landmarks) landmark.position = point(landmark.position);
  if (change.start) {
    const Vec2 at = point(change.start->position());
    change.start = Pose2{at.x(), at.y(), turn(change.start->heading)};
  }
  if (change.route) std::ranges::transform(*change.route, change.route->begin(), point);
  return change;
}

}  // namespace

MapChange aligned(const Map& map, const QStringList& keys, Alignment alignment) {
  MapChange change;
  const std::vector<Part> parts = partsOf(map, keys);
  if (parts.size() < 2) return change;
  const Bounds all = aroundAll(parts);
  for (const Part& part : parts)
    if (!part.locked) part.move(change, offsetTo(all, part.bounds, alignment));
  return change;
}

MapChange distributed(const Map& map, const QStringList& keys, Along along) {
  MapChange change;
  std::vector<Part> parts = partsOf(map, keys);
  if (parts.size() < 3) return change;
  const int axis = along == Along::X ? 0 : 1;
  std::ranges::stable_sort(parts, {},
                           [&](const Part& part) { return middleOf(part.bounds)[axis]; });
  double extents = 0.0;
  for (const Part& part : parts) extents += part.bounds.high[axis] - part.bounds.low[axis];
  const double room = parts.back().bounds.high[axis] - parts.front().bounds.low[axis];
  const double gap = (room - extents) / static_cast<double>(parts.size() - 1);
  double at = parts.front().bounds.low[axis];
  for (const Part& part : parts) {
    Vec2 offset = Vec2::Zero();
    offset[axis] = at - part.bounds.low[axis];
    const bool outermost = &part == &parts.front() || &part == &parts.back();
    if (!outermost && !part.locked) part.move(change, offset);
    at += part.bounds.high[axis] - part.bounds.low[axis] + gap;
  }
  return change;
}

MapChange squaredUp(const Map& map, const QStringList& keys) {
  MapChange change = movable(map, keys);
  for (Building& building : change.buildings) {
    if (auto* outline = std::get_if<Polygon>(&building.shape)) {
      if (const auto squared = squaredUp(*outline)) *outline = *squared;
      continue;
    }
    auto& box = std::get<Rectangle>(building.shape);
    const double turn = turnToParallel(box.heading, 0.0);
    // Whole right angles exactly.
    if (std::abs(turn) <= kNearAxes)
      box.heading = std::round((box.heading + turn) / (kPi / 2.0)) * (kPi / 2.0);
  }
  return {.buildings = std::move(change.buildings)};
}

MapChange madeParallel(const Map& map, const QStringList& keys) {
  MapChange change = movable(map, keys);
  const std::vector<Building> chosen = selected(map, keys).buildings;
  const Building* guide = nullptr;
  if (chosen.size() > 1)
    guide = &*std::ranges::max_element(chosen, {}, [](const Building& building) {
      return std::pair(building.flags.locked, std::abs(signedArea(building.footprint())));
    });
  const std::vector<Other> others = othersThan(map, keys);
  for (Building& building : change.buildings) {
    const Building* other = guide != nullptr ? guide : nearestOf(others, building);
    if (other != nullptr)
      building = turnedBy(building, turnToParallel(headingOf(building), headingOf(*other)));
  }
  return {.buildings = std::move(change.buildings)};
}

MapChange turnedByQuarter(const Map& map, const QStringList& keys, bool clockwise) {
  const double turn = clockwise ? -kPi / 2.0 : kPi / 2.0;
  return transformed(
      map, keys,
      [clockwise](const Vec2& from_middle) {
        return clockwise ? Vec2(from_middle.y(), -from_middle.x())
                         : Vec2(-from_middle.y(), from_middle.x());
      },
      [turn](double heading) { return normalizedAngle(heading + turn); });
}

MapChange mirrored(const Map& map, const QStringList& keys, Along along) {
  const bool x = along == Along::X;
  return transformed(
      map, keys,
      [x](const Vec2& from_middle) {
        return x ? Vec2(-from_middle.x(), from_middle.y())
                 : Vec2(from_middle.x(), -from_middle.y());
      },
      [x](double heading) { return normalizedAngle(x ? kPi - heading : -heading); });
}

MapChange scaled(const Map& map, double factor) {
  const auto point = [factor](const Vec2& at) { return Vec2(factor * at); };
  MapChange change{map.buildings, map.landmarks, map.start, map.route, map.underlays};
  for (Building& building : change.buildings) {
    building.estimate.reset();
    building.sides.reset();
    if (auto* box = std::get_if<Rectangle>(&building.shape)) {
      *box = {point(box->centre), factor * box->width, factor * box->depth, box->heading};
    } else {
      auto& outline = std::get<Polygon>(building.shape);
      std::ranges::transform(outline, outline.begin(), point);
    }
  }
  for (Landmark& landmark : change.landmarks) landmark.position = point(landmark.position);
  if (change.start) {
    change.start = Pose2{factor * change.start->x, factor * change.start->y, change.start->heading};
  }
  std::ranges::transform(*change.route, change.route->begin(), point);
  for (Underlay& underlay : *change.underlays) {
    underlay.x *= factor;
    underlay.y *= factor;
    underlay.metres_per_pixel *= factor;
  }
  return change;
}

MapChange arrayed(const Map& map, const QStringList& keys, int columns, int rows,
                  const Vec2& step) {
  MapChange all;
  MapChange objects = selected(map, keys);
  objects.start.reset();
  objects.route.reset();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (row == 0 && column == 0) continue;
      const MapChange copy = moved(objects, {column * step.x(), row * step.y()});
      all.buildings.insert(all.buildings.end(), copy.buildings.begin(), copy.buildings.end());
      all.landmarks.insert(all.landmarks.end(), copy.landmarks.begin(), copy.landmarks.end());
    }
  }
  return all;
}

MapChange asPolygons(const Map& map, const QStringList& keys) {
  MapChange change = movable(map, keys);
  for (Building& building : change.buildings) building.shape = building.footprint();
  return {.buildings = std::move(change.buildings)};
}

MapChange lockToggled(const Map& map, const QStringList& keys) {
  std::vector<Building> buildings = selected(map, keys).buildings;
  const bool all_locked =
      std::ranges::all_of(buildings, [](const Building& b) { return b.flags.locked; });
  for (Building& building : buildings) building.flags.locked = !all_locked;
  return {.buildings = std::move(buildings)};
}

}  // namespace handmap
