#include "core/outlines/terraces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/outlines/joint_places.h"

namespace handmap {

namespace {

/// Nats for a drawn building that has a place at all, and for a place that has one: of twenty one
/// is not there, or was not drawn. Choice.
constexpr double kIsThere = 3.0;
/// Of the evidence: less is lost at the ends of the parts, which are not where the houses' are.
/// Choice; 0.95 to 1.04 in simulated terraces.
constexpr double kLeastLeft = 0.9;
constexpr double kWallToWall_m = 1.0;          // between places, along the terrace. Choice
constexpr double kParallel = toRadians(10.0);  // choice

using Places = std::vector<std::optional<FittedOutline>>;

struct Buildings {
  const std::vector<OutlineTask>& tasks;
  const Places& places;
  std::vector<bool> done;  ///< its terrace is decided

  bool hasPlace(std::size_t b) const { return places[b] && !done[b]; }
};

/// An interval along the terrace, and how deep it is there.
struct Stretch {
  double from, to;
  double middle, depth;  ///< across
  double centre() const { return 0.5 * (from + to); }
  double length() const { return to - from; }
};

Stretch stretchOf(const Polygon& outline, double heading) {
  const Rectangle box = boundingRectangle(outline, heading);
  const Vec2 along = unitVector(heading);
  const double centre = along.dot(box.centre);
  return {centre - 0.5 * box.width, centre + 0.5 * box.width, cross(along, box.centre), box.depth};
}

/// Places wall to wall.
struct Terrace {
  double heading;
  std::vector<std::size_t> houses;
  std::vector<Stretch> places;  ///< of the houses
  double from = 0.0, to = 0.0;
};

bool isParallel(const Polygon& outline, double heading) {
  return std::abs(std::remainder(headingOf(outline) - heading, kPi / 2.0)) < kParallel;
}

Terrace oneHouse(std::size_t b, double heading, const Places& places) {
  const Stretch place = stretchOf(places[b]->outline, heading);
  return {heading, {b}, {place}, place.from, place.to};
}

Terrace terraceAround(std::size_t first, double heading, const Buildings& buildings) {
  const Places& places = buildings.places;
  Terrace terrace = oneHouse(first, heading, places);
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (std::ranges::find(terrace.houses, k) != terrace.houses.end()) continue;
      if (!buildings.hasPlace(k) || !isParallel(places[k]->outline, heading)) continue;
      const Stretch other = stretchOf(places[k]->outline, heading);
      const bool beside = std::ranges::any_of(terrace.places, [&](const Stretch& house) {
        return std::max(house.from, other.from) - std::min(house.to, other.to) < kWallToWall_m &&
               std::abs(house.middle - other.middle) < 0.25 * (house.depth + other.depth);
      });
      if (!beside) continue;
      terrace.houses.push_back(k);
      terrace.places.push_back(other);
      terrace.from = std::min(terrace.from, other.from);
      terrace.to = std::max(terrace.to, other.to);
      grown = true;
    }
  }
  return terrace;
}

/// Those that have a place: the longer a wall the better it tells how the terrace is turned.
std::vector<std::size_t> longestFirst(const Places& places) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i]) order.push_back(i);
  }
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) {
    const Polygon& outline = places[i]->outline;
    const Rectangle box = boundingRectangle(outline, headingOf(outline));
    return std::max(box.width, box.depth);
  });
  return order;
}

/// Not of the terrace, and drawn on it or no farther from it than one σ.
std::vector<std::size_t> drawnOn(const Terrace& terrace, const Buildings& buildings) {
  const std::vector<OutlineTask>& tasks = buildings.tasks;
  std::vector<std::size_t> others;
  for (std::size_t b = 0; b < tasks.size(); ++b) {
    if (buildings.done[b]) continue;
    if (std::ranges::find(terrace.houses, b) != terrace.houses.end()) continue;
    const Stretch drawn = stretchOf(tasks[b].drawn, terrace.heading);
    const double off = tasks[b].drawn_shift_m;
    if (drawn.from > terrace.to + off || drawn.to < terrace.from - off) continue;
    const bool on_it = std::ranges::any_of(terrace.places, [&](const Stretch& house) {
      return std::abs(drawn.middle - house.middle) < 0.5 * (house.depth + drawn.depth) + off;
    });
    if (on_it) others.push_back(b);
  }
  return others;
}

/// Its length shared out among them, in the order and by the sizes of the drawing.
std::vector<TerraceHouse> divided(const Terrace& terrace, const std::vector<std::size_t>& among,
                                  const std::vector<OutlineTask>& tasks) {
  struct Part {
    std::size_t building;
    Stretch drawn;
  };
  std::vector<Part> parts;
  double drawn_m = 0.0;
  for (const std::size_t b : among) {
    parts.push_back({b, stretchOf(tasks[b].drawn, terrace.heading)});
    drawn_m += parts.back().drawn.length();
  }
  std::ranges::stable_sort(parts, {}, [](const Part& part) { return part.drawn.centre(); });
  const Vec2 along = unitVector(terrace.heading);
  std::vector<TerraceHouse> houses;
  double from = terrace.from;
  for (const auto& [building, drawn] : parts) {
    const double width = (terrace.to - terrace.from) * drawn.length() / drawn_m;
    const Stretch& there = *std::ranges::max_element(terrace.places, {}, [&](const Stretch& house) {
      return std::min(house.to, from + width) - std::max(house.from, from);
    });
    const Vec2 centre = (from + 0.5 * width) * along + there.middle * perpendicular(along);
    const OutlinePrior prior = priorOf(asDrawn(tasks[building]));
    houses.push_back(
        {building, prior, placedOn({centre, width, there.depth, terrace.heading}, prior)});
    from += width;
  }
  return houses;
}

double priorsOf(const std::vector<TerraceHouse>& houses) {
  double nats = 0.0;
  for (const TerraceHouse& house : houses) nats += house.place.prior;
  return nats;
}

/// As it is drawn, whatever was found for it.
double priorAsItIs(std::size_t b, double heading, const Buildings& buildings) {
  const Rectangle box = boundingRectangle(buildings.places[b]->outline, heading);
  return placedOn(box, priorOf(asDrawn(buildings.tasks[b]))).prior;
}

/// What returns say for any of some outlines, each once.
class Evidence {
 public:
  Evidence(const PlacedRays& placed, double range_limit_m)
      : placed_(placed),
        range_limit_m_(range_limit_m),
        nobody_(placed.rays.size(), kNobody),
        nats_(placed.rays.size(), 0.0F) {}
  void add(const OutlinePrior& prior, const Polygon& outline) {
    const OutlineScorer scorer = scorerFor(prior, placed_, range_limit_m_, nobody_, kNobody);
    for (const OutlineScorer::Standing& claim : scorer.standingFor(outline, kOwnedWithin_m)) {
      nats_[claim.ray] = std::max(nats_[claim.ray], static_cast<float>(claim.nats()));
    }
  }
  double total() const { return std::accumulate(nats_.begin(), nats_.end(), 0.0); }

 private:
  const PlacedRays& placed_;
  double range_limit_m_;
  RayOwners nobody_;
  std::vector<float> nats_;
};

struct Division {
  std::vector<TerraceHouse> houses;
  double gain = 0.0;  ///< of the priors, nats
};

/// With those of the others that make it more probable.
Division divisionOf(const Terrace& terrace, const Buildings& buildings) {
  std::vector<std::size_t> others = drawnOn(terrace, buildings);
  std::vector<std::size_t> among = terrace.houses;
  double before = 0.0;
  for (const std::size_t b : among) before += priorAsItIs(b, terrace.heading, buildings);
  Division best;
  while (!others.empty()) {
    std::size_t taken = others.size();
    for (std::size_t k = 0; k < others.size(); ++k) {
      among.push_back(others[k]);
      std::vector<TerraceHouse> houses = divided(terrace, among, buildings.tasks);
      double gain = priorsOf(houses) - before;
      for (std::size_t n = terrace.houses.size(); n < among.size(); ++n) {
        const std::size_t b = among[n];
        gain +=
            buildings.places[b] ? -kIsThere - priorAsItIs(b, terrace.heading, buildings) : kIsThere;
      }
      among.pop_back();
      if (gain <= best.gain) continue;
      best = {std::move(houses), gain};
      taken = k;
    }
    if (taken == others.size()) break;
    among.push_back(others[taken]);
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(taken));
  }
  return best;
}

/// Whether the returns that stood for the houses stand for those of the division.
bool leavesEvidence(const Division& division, const Terrace& terrace, const Buildings& buildings,
                    const PlacedRays& placed, double range_limit_m) {
  Evidence before(placed, range_limit_m);
  Evidence after(placed, range_limit_m);
  for (const std::size_t b : terrace.houses) {
    before.add(priorOf(asDrawn(buildings.tasks[b])), buildings.places[b]->outline);
  }
  for (const auto& [building, prior, place] : division.houses) after.add(prior, place.outline);
  return after.total() >= kLeastLeft * before.total();
}

}  // namespace

std::vector<TerraceHouse> dividedTerraces(const std::vector<OutlineTask>& tasks,
                                          const Places& places, const PlacedRays& placed,
                                          double range_limit_m, const std::stop_token& stop) {
  const RayOwners nobody(placed.rays.size(), kNobody);
  Buildings buildings{tasks, places, std::vector<bool>(tasks.size(), false)};
  std::vector<TerraceHouse> all;
  const auto divide = [&](const Terrace& terrace, Division division) {
    if (!leavesEvidence(division, terrace, buildings, placed, range_limit_m)) return false;
    for (TerraceHouse& house : division.houses) {
      buildings.done[house.building] = true;
      scorePlace(house.place, scorerFor(house.prior, placed, range_limit_m, nobody,
                                        static_cast<int>(house.building)));
      all.push_back(std::move(house));
    }
    return true;
  };
  for (const std::size_t i : longestFirst(places)) {
    if (stop.stop_requested()) break;
    if (buildings.done[i]) continue;
    const double heading = headingOf(places[i]->outline);
    Terrace terrace = terraceAround(i, heading, buildings);
    Division division = divisionOf(terrace, buildings);
    Terrace across = terraceAround(i, heading + kPi / 2.0, buildings);
    Division other = divisionOf(across, buildings);
    if (other.gain > division.gain) {
      std::swap(terrace, across);
      std::swap(division, other);
    }
    if (division.houses.empty()) continue;
    for (const std::size_t b : terrace.houses) buildings.done[b] = true;
    if (divide(terrace, std::move(division))) continue;
    // Where fronts are stepped the houses that are right would be lost with the others.
    for (const std::size_t b : terrace.houses) {
      const Terrace alone = oneHouse(b, terrace.heading, places);
      Division of_one = divisionOf(alone, buildings);
      if (!of_one.houses.empty()) divide(alone, std::move(of_one));
    }
  }
  return all;
}

}  // namespace handmap
