#include "core/map/concerns.h"

#include <algorithm>
#include <cmath>

#include "core/map/certainty.h"
#include "core/map/map_changes.h"

namespace handmap {

namespace {

constexpr double kFar = 3.0;  // σ of the drawing; three of a thousand are farther off by chance
/// Drawings from memory are turned by some 3° (kMostTurn of core/outlines, 0.08 rad, is the most
/// that is expected of them, one σ).
constexpr double kMuchTurned = toRadians(15.0);
/// Of the smaller building: neighbours of real places that are fitted each for itself share less.
constexpr double kMuchShared = 0.1;

struct Laid {
  std::size_t building;
  Polygon polygon;
  Bounds bounds;
};

std::vector<Laid> outlinesFromTheLeft(const Map& map) {
  std::vector<Laid> outlines;
  for (std::size_t b = 0; b < map.buildings.size(); ++b) {
    Polygon polygon = map.buildings[b].footprint();
    if (!isSimple(polygon)) continue;
    const Bounds bounds = boundsOf(polygon);
    outlines.push_back({b, std::move(polygon), bounds});
  }
  std::ranges::sort(outlines, {}, [](const Laid& outline) { return outline.bounds.low.x(); });
  return outlines;
}

double sharedOfSmaller(const Polygon& a, const Polygon& b) {
  if (!isSimple(a) || !isSimple(b) || !overlap(a, b)) return 0.0;
  return intersectionArea(a, b) / std::min(std::abs(signedArea(a)), std::abs(signedArea(b)));
}

void addOverlaps(const Map& drawing, const Map& refined, std::vector<Concern>& concerns) {
  const std::vector<Laid> outlines = outlinesFromTheLeft(refined);
  for (auto a = outlines.begin(); a != outlines.end(); ++a) {
    for (auto b = a + 1; b != outlines.end() && b->bounds.low.x() < a->bounds.high.x(); ++b) {
      if (!a->bounds.overlaps(b->bounds)) continue;
      if (!isRecognised(refined.buildings[a->building]) &&
          !isRecognised(refined.buildings[b->building])) {
        continue;
      }
      const double more = sharedOfSmaller(a->polygon, b->polygon) -
                          sharedOfSmaller(drawing.buildings[a->building].footprint(),
                                          drawing.buildings[b->building].footprint());
      if (more < kMuchShared) continue;
      concerns.push_back({Concern::Kind::Overlaps, a->building, b->building, more});
      concerns.push_back({Concern::Kind::Overlaps, b->building, a->building, more});
    }
  }
}

}  // namespace

std::vector<Concern> concernsOf(const Map& drawing, const Map& refined) {
  std::vector<Concern> concerns;
  const std::size_t count = std::min(drawing.buildings.size(), refined.buildings.size());
  for (std::size_t b = 0; b < count; ++b) {
    if (!isRecognised(refined.buildings[b])) continue;
    const BuildingChange change = changeOf(drawing.buildings[b], refined.buildings[b]);
    const Uncertainty drawn = drawing.uncertaintyOf(drawing.buildings[b]);
    // A middle is also moved where one side alone is put elsewhere.
    const double off_m = std::hypot(drawn.position, 0.5 * drawn.size);
    if (change.moved_m() > std::max(kFar * off_m, kLeastGrowth_m))
      concerns.push_back({Concern::Kind::Moved, b, 0, change.moved_m()});
    if (std::abs(change.turned) > kMuchTurned)
      concerns.push_back({Concern::Kind::Turned, b, 0, change.turned});
    if (std::abs(change.grown_m()) > std::max(kFar * drawn.size, kLeastGrowth_m))
      concerns.push_back({Concern::Kind::Resized, b, 0, change.grown_m()});
  }
  addOverlaps(drawing, refined, concerns);
  std::ranges::stable_sort(concerns, {}, &Concern::building);
  return concerns;
}

std::span<const Concern> concernsAbout(std::size_t building, std::span<const Concern> concerns) {
  const auto low = std::ranges::lower_bound(concerns, building, {}, &Concern::building);
  const auto high = std::ranges::upper_bound(concerns, building, {}, &Concern::building);
  return concerns.subspan(static_cast<std::size_t>(low - concerns.begin()),
                          static_cast<std::size_t>(high - low));
}

}  // namespace handmap
