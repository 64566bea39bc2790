#include "core/outlines/terraces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/outlines/constants.h"
#include "core/outlines/joint_places.h"
#include "core/outlines/row_division.h"
#include "core/outlines/row_faces.h"

namespace handmap {

using namespace outlines;

namespace {

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

/// Places wall to wall, or with walls between them that nobody drew.
struct Terrace {
  double heading;
  std::vector<std::size_t> houses;
  std::vector<Stretch> places;  ///< of the houses
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();

  void add(std::size_t b, const Stretch& place) {
    houses.push_back(b);
    places.push_back(place);
    from = std::min(from, place.from);
    to = std::max(to, place.to);
  }
  bool has(std::size_t b) const { return std::ranges::find(houses, b) != houses.end(); }
  bool isBeside(const Stretch& other) const {
    if (std::max(from, other.from) - std::min(to, other.to) >= kWallToWall_m) return false;
    return std::ranges::any_of(places, [&](const Stretch& house) {
      return std::abs(house.middle - other.middle) < 0.25 * (house.depth + other.depth);
    });
  }
  double middle() const {  // across
    double sum = 0.0;
    for (const Stretch& place : places) sum += place.middle / static_cast<double>(places.size());
    return sum;
  }
};

RowBand bandOf(const Terrace& terrace) {
  RowBand band{terrace.heading, terrace.from, terrace.to, 1e300, -1e300};
  for (const Stretch& place : terrace.places) {
    band.low = std::min(band.low, place.middle - 0.5 * place.depth - kFaceOff_m);
    band.high = std::max(band.high, place.middle + 0.5 * place.depth + kFaceOff_m);
  }
  return band;
}

/// With one face to each side, as those of a row have: not with wings.
bool isHouse(const Polygon& outline) {
  const Rectangle box = boundingRectangle(outline, headingOf(outline));
  return std::abs(signedArea(outline)) > kHouseFills * box.width * box.depth;
}

bool isParallel(const Polygon& outline, double heading) {
  return std::abs(std::remainder(headingOf(outline) - heading, kPi / 2.0)) < kRowTurn;
}

/// As far as walls are seen on from its places, and what has its place there.
Terrace terraceAround(std::size_t first, double heading, const Buildings& buildings,
                      const PlacedRays& placed) {
  const Places& places = buildings.places;
  Terrace terrace{heading, {}, {}};
  terrace.add(first, stretchOf(places[first]->outline, heading));
  for (std::size_t before = 0; before < terrace.houses.size();) {
    before = terrace.houses.size();
    const double length = terrace.to - terrace.from;
    RowBand wider = bandOf(terrace);
    wider.from -= length;
    wider.to += length;
    std::tie(terrace.from, terrace.to) =
        RowFaces(placed, wider).seenAround(terrace.from, terrace.to);
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (terrace.has(k) || !buildings.hasPlace(k)) continue;
      const Polygon& outline = places[k]->outline;
      if (!isHouse(outline) || !isParallel(outline, heading)) continue;
      const Stretch other = stretchOf(outline, heading);
      if (terrace.isBeside(other)) terrace.add(k, other);
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
    if (buildings.done[b] || terrace.has(b) || !isHouse(tasks[b].drawn)) continue;
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

/// As it is drawn, whatever was found for it.
double priorAsItIs(std::size_t b, double heading, const Buildings& buildings) {
  const Rectangle box = boundingRectangle(buildings.places[b]->outline, heading);
  return placedOn(box, priorOf(asDrawn(buildings.tasks[b]))).prior;
}

RowHouse rowHouseOf(std::size_t b, const Terrace& terrace, const Buildings& buildings) {
  const OutlinePrior prior = priorOf(asDrawn(buildings.tasks[b]));
  const Rectangle box = boundingRectangle(prior.start, prior.heading);
  const bool across = std::abs(std::sin(terrace.heading - prior.heading)) > std::sqrt(0.5);
  const int axis = across ? 1 : 0;
  const double width = across ? box.depth : box.width;
  const Stretch drawn = stretchOf(prior.start, terrace.heading);
  RowHouse house;
  house.centre = drawn.centre();
  house.centre_sigma = prior.shift_m;
  house.width = width * std::exp(prior.expected_log_size[axis]);
  house.log_width_sigma = prior.log_scale;
  house.least_width = house.width / std::exp(kMostSizeOff);
  house.most_width = house.width * std::exp(kMostSizeOff);
  house.nats = -0.5 * std::pow((drawn.middle - terrace.middle()) / prior.shift_m, 2);
  if (!terrace.has(b) && buildings.places[b]) {
    // Never less than nothing: what is there may be another thing.
    house.worth_elsewhere =
        std::max(0.0, 2.0 * kTells + priorAsItIs(b, terrace.heading, buildings));
  }
  return house;
}

/// As deep as its faces are seen, else as it is drawn: what was found there may have been made
/// shallow by the gaps of the row.
Rectangle boxOf(const RowPart& part, double drawn_depth, const Terrace& terrace,
                const RowFaces& faces) {
  const Stretch& there = *std::ranges::max_element(terrace.places, {}, [&](const Stretch& house) {
    return std::min(house.to, part.to) - std::max(house.from, part.from);
  });
  std::optional<double> low = faces.across(RowFaces::kLow, part.from, part.to);
  std::optional<double> high = faces.across(RowFaces::kHigh, part.from, part.to);
  if (low && high && *high - *low < 0.5 * there.depth) low = high = std::nullopt;
  if (!low && !high) low = there.middle - 0.5 * drawn_depth;
  if (!low) low = *high - drawn_depth;
  if (!high) high = *low + drawn_depth;
  const Vec2 along = unitVector(terrace.heading);
  return {0.5 * (part.from + part.to) * along + 0.5 * (*low + *high) * perpendicular(along),
          part.to - part.from, *high - *low, terrace.heading};
}

/// Empty where it is all of the houses that have their places there: those tell more of their ends.
std::vector<TerraceHouse> divided(const Terrace& terrace, const Buildings& buildings,
                                  const PlacedRays& placed, const std::stop_token& stop) {
  std::vector<std::size_t> among = drawnOn(terrace, buildings);
  among.insert(among.end(), terrace.houses.begin(), terrace.houses.end());
  std::ranges::stable_sort(among, {}, [&](std::size_t b) {
    return stretchOf(asDrawn(buildings.tasks[b]).start, terrace.heading).centre();
  });
  std::vector<RowHouse> row;
  for (const std::size_t b : among) row.push_back(rowHouseOf(b, terrace, buildings));
  const RowFaces faces(placed, bandOf(terrace));
  const auto evidence = [&](double from, double to) { return faces.evidence(from, to); };
  const Vec2 along = unitVector(terrace.heading);
  std::vector<TerraceHouse> houses;
  bool more = false;
  for (const RowPart& part : divideRow(row, terrace.from, terrace.to, evidence, stop)) {
    more = more || part.house == kUndrawn || !terrace.has(among[part.house]);
    if (part.house == kUndrawn) continue;
    const std::size_t b = among[part.house];
    const OutlinePrior prior = priorOf(asDrawn(buildings.tasks[b]));
    const double drawn_depth = stretchOf(prior.start, terrace.heading).depth;
    const Rectangle box = boxOf(part, drawn_depth, terrace, faces);
    houses.push_back({b,
                      prior,
                      placedOn(box, prior),
                      {along, part.from_sigma, part.to_sigma, 1.0 - part.probability}});
  }
  for (const std::size_t b : terrace.houses) {
    const bool is_in =
        std::ranges::any_of(houses, [&](const TerraceHouse& house) { return house.building == b; });
    if (!is_in) houses.push_back({b, priorOf(buildings.tasks[b]), std::nullopt, {}});
  }
  if (!more) houses.clear();
  return houses;
}

}  // namespace

std::vector<TerraceHouse> dividedTerraces(const std::vector<OutlineTask>& tasks,
                                          const Places& places, const PlacedRays& placed,
                                          double range_limit_m, const std::stop_token& stop) {
  const RayOwners nobody(placed.rays.size(), kNobody);
  Buildings buildings{tasks, places, std::vector<bool>(tasks.size(), false)};
  std::vector<TerraceHouse> all;
  for (const std::size_t i : longestFirst(places)) {
    if (stop.stop_requested()) break;
    if (buildings.done[i] || !isHouse(places[i]->outline)) continue;
    const double heading = headingOf(places[i]->outline);
    for (const double along : {heading, heading + kPi / 2.0}) {
      Terrace terrace = terraceAround(i, along, buildings, placed);
      if (terrace.houses.size() < 2) continue;  // a house
      // As its faces are turned, which one house may be not.
      const double turn = RowFaces(placed, bandOf(terrace)).turn();
      terrace = terraceAround(i, along + turn, buildings, placed);
      std::vector<TerraceHouse> houses = divided(terrace, buildings, placed, stop);
      if (houses.empty()) continue;
      for (const std::size_t b : terrace.houses) buildings.done[b] = true;
      for (TerraceHouse& house : houses) {
        buildings.done[house.building] = true;
        const int building = static_cast<int>(house.building);
        if (house.place) {
          scorePlace(*house.place, scorerFor(house.prior, placed, range_limit_m, nobody, building));
        }
        all.push_back(std::move(house));
      }
      break;
    }
  }
  return all;
}

}  // namespace handmap
