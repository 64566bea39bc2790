#include "core/map/map_changes.h"

#include <algorithm>
#include <cmath>

#include "core/map/certainty.h"

namespace handmap {

namespace {

/// Of the corners about their middles, as well as they can be laid on each other.
double turnOf(const Building& drawn, const Building& now) {
  const Polygon before = drawn.footprint();
  const Polygon after = now.footprint();
  if (before.size() != after.size()) return 0.0;
  Vec2 middle_before = Vec2::Zero();
  Vec2 middle_after = Vec2::Zero();
  for (std::size_t i = 0; i < before.size(); ++i) {
    middle_before += before[i] / static_cast<double>(before.size());
    middle_after += after[i] / static_cast<double>(after.size());
  }
  double across = 0.0;
  double along = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    across += cross(before[i] - middle_before, after[i] - middle_after);
    along += (before[i] - middle_before).dot(after[i] - middle_after);
  }
  const double turn = std::atan2(across, along);
  // The corners of a rectangle may be counted from another one.
  return before.size() == 4 ? std::remainder(turn, kPi / 2.0) : turn;
}

bool isOneSided(const Building& now) {
  const Sides sides = sidesOf(now);
  return std::ranges::count_if(sides, &SideEstimate::seen) == 1;
}

}  // namespace

double BuildingChange::grown_m() const {
  return std::abs(wider_m) > std::abs(deeper_m) ? wider_m : deeper_m;
}
bool BuildingChange::isTurned() const { return std::abs(turned) >= kLeastTurn; }
bool BuildingChange::isResized() const { return std::abs(grown_m()) >= kLeastGrowth_m; }

BuildingChange changeOf(const Building& drawn, const Building& now) {
  BuildingChange change;
  change.drawn = centroid(drawn.footprint());
  change.now = centroid(now.footprint());
  change.turned = turnOf(drawn, now);
  const Rectangle before = drawn.box();
  const Rectangle after = boundingRectangle(now.footprint(), before.heading + change.turned);
  change.wider_m = after.width - before.width;
  change.deeper_m = after.depth - before.depth;
  change.doubt = doubtOf(now);
  change.one_sided = isOneSided(now);
  return change;
}

MapChanges changesOf(const Map& drawing, const Map& refined) {
  MapChanges changes;
  const std::size_t count = std::min(drawing.buildings.size(), refined.buildings.size());
  for (std::size_t b = 0; b < count; ++b) {
    const Building& now = refined.buildings[b];
    BuildingChange change = changeOf(drawing.buildings[b], now);
    change.building = b;
    if (change.doubt > 0.0) changes.doubtful.push_back(change);
    if (drawing.buildings[b].fixed) {
      changes.kept.push_back(change);
      continue;
    }
    if (!isRecognised(now)) {
      changes.unseen.push_back(change);
      continue;
    }
    const bool moved = change.moved_m() >= kLeastMove_m;
    if (moved) changes.moved.push_back(change);
    if (change.isTurned()) changes.turned.push_back(change);
    if (change.isResized()) changes.resized.push_back(change);
    if (!moved && !change.isTurned() && !change.isResized()) changes.kept.push_back(change);
    if (change.one_sided) changes.one_sided.push_back(change);
  }
  const auto by = [](auto of) {
    return [of](const BuildingChange& a, const BuildingChange& b) { return of(a) > of(b); };
  };
  std::ranges::stable_sort(changes.moved, std::greater(), &BuildingChange::moved_m);
  std::ranges::stable_sort(
      changes.turned, by([](const BuildingChange& change) { return std::abs(change.turned); }));
  std::ranges::stable_sort(
      changes.resized, by([](const BuildingChange& change) { return std::abs(change.grown_m()); }));
  std::ranges::stable_sort(changes.doubtful, std::greater(), &BuildingChange::doubt);
  return changes;
}

TrueMiddles::TrueMiddles(const Map& truth) {
  for (const Building& building : truth.buildings)
    middles_.emplace(building.id, centroid(building.footprint()));
}

std::optional<double> TrueMiddles::errorOf(const Building& building) const {
  const auto middle = middles_.find(building.id);
  if (middle == middles_.end()) return std::nullopt;
  return (centroid(building.footprint()) - middle->second).norm();
}

}  // namespace handmap
