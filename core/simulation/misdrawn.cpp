#include "core/simulation/misdrawn.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/random.h"
#include "core/simulation/route.h"

namespace handmap {

namespace {

constexpr std::uint32_t kMisdrawn = 46;
constexpr int kWrongPlacings = 1000;
constexpr double kWrongNearest_m =
    4.0;  // choice: from the route, as the nearest fronts of the scenes
constexpr double kWrongFarthest_m = 20.0;

/// Of the size of one that is drawn, looking at the route; nullopt where it meets something.
std::optional<Rectangle> somewhere(const Map& drawing, const Map& truth, const Route& route,
                                   RandomStream& random) {
  const int like = random.index(static_cast<int>(drawing.buildings.size()));
  Rectangle box = drawing.buildings[static_cast<std::size_t>(like)].box();
  const Pose2 beside = route.poseAt(random.uniform(0.0, route.length()));
  const double away = random.uniform(kWrongNearest_m, kWrongFarthest_m) + box.depth / 2.0;
  box.centre = beside.toOuter({0.0, random.uniform() < 0.5 ? away : -away});
  box.heading = beside.heading;
  const Polygon corners = box.corners();
  const auto meets = [&](const Building& other) { return overlap(corners, other.footprint()); };
  const bool free = route.distanceTo(corners) > kWrongNearest_m / 2.0 &&
                    std::none_of(drawing.buildings.begin(), drawing.buildings.end(), meets) &&
                    std::none_of(truth.buildings.begin(), truth.buildings.end(), meets);
  return free ? std::optional(box) : std::nullopt;
}

void addWrong(Map& drawing, const Map& truth, int count, RandomStream& random) {
  const std::optional<Route> route = routeOf(truth);
  int added = 0;
  for (int i = 0; route && i < kWrongPlacings && added < count; ++i) {
    const auto box = somewhere(drawing, truth, *route, random);
    if (!box) continue;
    Building building;
    building.id = fmt::format("wrong {}", ++added);
    building.shape = *box;
    drawing.buildings.push_back(building);
  }
  if (added == count) return;
  throwBadInput(phrase("buildings that are not there"), "",
                phrase("room for {} beside the route", added), std::to_string(count));
}

void leaveOut(std::vector<Building>& buildings, int count, RandomStream& random) {
  const auto may_go = std::count_if(buildings.begin(), buildings.end(),
                                    [](const Building& building) { return !building.fixed; });
  if (may_go <= count) {
    throwBadInput(phrase("buildings to leave out"), "", std::to_string(may_go),
                  phrase("more than {}", count));
  }
  while (count > 0) {
    const auto at = buildings.begin() + random.index(static_cast<int>(buildings.size()));
    if (at->fixed) continue;
    buildings.erase(at);
    --count;
  }
}

}  // namespace

Map misdrawn(Map drawing, const Map& truth, const Misdrawing& misdrawing, std::uint64_t seed) {
  RandomStream random(seed, 0, 0, kMisdrawn);
  const double direction = random.uniform(-kPi, kPi);
  const double turn = random.uniform() < 0.5 ? 1.0 : -1.0;
  if (misdrawing.start_m > 0.0 || misdrawing.start_turn_rad > 0.0) {
    if (!drawing.start) {
      throwBadInput(phrase("start"), "", phrase("none"), phrase("one that can be off"));
    }
    const Vec2 place = drawing.start->position() + misdrawing.start_m * unitVector(direction);
    drawing.start = {place.x(), place.y(),
                     normalizedAngle(drawing.start->heading + turn * misdrawing.start_turn_rad)};
    drawing.start_uncertainty = {misdrawing.start_m, misdrawing.start_turn_rad};
  }
  if (misdrawing.wrong == 0) return drawing;
  std::vector<Building> kept = drawing.buildings;
  leaveOut(kept, misdrawing.wrong, random);
  const std::size_t drawn = drawing.buildings.size();
  addWrong(drawing, truth, misdrawing.wrong, random);
  kept.insert(kept.end(), drawing.buildings.begin() + static_cast<std::ptrdiff_t>(drawn),
              drawing.buildings.end());
  drawing.buildings = std::move(kept);
  return drawing;
}

}  // namespace handmap
