#include "core/outlines/terraces.h"

#include <algorithm>
#include <cmath>

#include "core/outlines/joint_places.h"

namespace handmap {

namespace {

/// Nats for a drawn building that has a place at all: of twenty one is not there. Choice.
constexpr double kIsThere = 3.0;
/// Of the evidence: less is lost at the ends of the parts, which are not where the houses' are.
/// Choice; 0.95 to 1.04 in simulated terraces.
constexpr double kLeastLeft = 0.9;

struct Part {
  std::size_t building;
  double at;     ///< middle along the terrace, as drawn
  double width;  ///< along it, as drawn
};

/// The place along the side in which it is larger than drawn by more.
Rectangle alongTerrace(const Polygon& place, const Polygon& drawn) {
  const double heading = headingOf(place);
  const Rectangle box = boundingRectangle(place, heading);
  const Rectangle as_drawn = boundingRectangle(drawn, heading);
  if (box.width / as_drawn.width >= box.depth / as_drawn.depth) return box;
  return boundingRectangle(place, heading + kPi / 2.0);
}

/// Those that are drawn on the place, in order. The first building's middle may lie elsewhere.
std::vector<Part> partsOf(std::size_t whole, const Rectangle& terrace,
                          const std::vector<OutlineTask>& tasks,
                          const std::vector<std::optional<FittedOutline>>& places) {
  const Vec2 along = unitVector(terrace.heading);
  std::vector<Part> parts;
  for (std::size_t b = 0; b < tasks.size(); ++b) {
    if (b != whole && places[b]) continue;
    const Rectangle drawn = boundingRectangle(tasks[b].drawn, terrace.heading);
    const Vec2 off = drawn.centre - terrace.centre;
    const bool on_it = std::abs(along.dot(off)) <= 0.5 * terrace.width &&
                       std::abs(cross(along, off)) <= 0.5 * (terrace.depth + drawn.depth);
    if (b == whole || on_it) parts.push_back({b, along.dot(drawn.centre), drawn.width});
  }
  std::ranges::stable_sort(parts, {}, &Part::at);
  return parts;
}

}  // namespace

std::vector<TerraceHouse> dividedTerrace(std::size_t whole, const std::vector<OutlineTask>& tasks,
                                         const std::vector<std::optional<FittedOutline>>& places,
                                         const PlacedRays& placed, double range_limit_m) {
  if (!places[whole]) return {};
  const Rectangle terrace = alongTerrace(places[whole]->outline, tasks[whole].drawn);
  const std::vector<Part> parts = partsOf(whole, terrace, tasks, places);
  if (parts.size() == 1) return {};
  double drawn_m = 0.0;
  for (const Part& part : parts) drawn_m += part.width;
  const RayOwners nobody(placed.rays.size(), kNobody);
  std::vector<TerraceHouse> houses;
  double evidence = 0.0;
  double prior_nats = kIsThere * static_cast<double>(parts.size() - 1);
  double done = -0.5 * terrace.width;
  for (const Part& part : parts) {
    const double width = terrace.width * part.width / drawn_m;
    const Vec2 centre = terrace.centre + (done + 0.5 * width) * unitVector(terrace.heading);
    done += width;
    const OutlinePrior prior = priorOf(asDrawn(tasks[part.building]));
    const OutlineScorer scorer =
        scorerFor(prior, placed, range_limit_m, nobody, static_cast<int>(part.building));
    houses.push_back({part.building, prior,
                      placedOn({centre, width, terrace.depth, terrace.heading}, prior, scorer)});
    evidence += houses.back().place.score;
    prior_nats += houses.back().place.prior;
  }
  const bool divided =
      prior_nats > places[whole]->prior && evidence >= kLeastLeft * places[whole]->score;
  return divided ? houses : std::vector<TerraceHouse>{};
}

}  // namespace handmap
