#include <algorithm>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/random.h"
#include "core/simulation/possible_drawing.h"
#include "core/simulation/route.h"
#include "core/simulation/world.h"

namespace handmap {

namespace {

constexpr std::uint32_t kPerturbed = 4;
constexpr int kSweeps = 10;
constexpr int kPlacings = 200;
constexpr std::size_t kMaxBuildings = 5000;  // each is held against all others
constexpr double kWay = 2.0;                 // half the width of the route that stays free

/// What people keep right however wrong the measures are.
struct Place {
  Polygon footprint;
  Bounds bounds;                           ///< of the footprint
  std::optional<Route::Projection> along;  ///< of the centre on the route, where there is one
};

bool sameOrder(const Place& a, const Place& true_a, const Place& b, const Place& true_b) {
  if (!a.along || true_a.along->offset * true_b.along->offset < 0.0) return true;
  return (a.along->s - b.along->s) * (true_a.along->s - true_b.along->s) >= 0.0;
}

class Perturbation {
 public:
  Perturbation(const Map& truth, const Redraw& redraw, std::uint64_t seed, Keeping keeping)
      : truth_(truth),
        redraw_(redraw),
        keeps_(keeping == Keeping::SideAndOrder),
        random_(seed, 0, 0, kPerturbed),
        route_(routeOf(truth)) {
    for (const Building& building : truth.buildings) true_places_.push_back(placeOf(building));
    places_ = true_places_;
    buildings_ = truth.buildings;
  }

  /// Gibbs sampling of the normal distribution cut off where drawings are impossible: each building
  /// in turn is drawn anew among the others as they stand, so a possible map stays possible.
  std::vector<Building> draw() {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (std::size_t i = 0; i < buildings_.size(); ++i) {
        if (!truth_.buildings[i].fixed) redraw(i);
      }
    }
    return std::move(buildings_);
  }

 private:
  Place placeOf(const Building& building) const {
    const Polygon footprint = building.footprint();
    Place place{footprint, boundsOf(footprint), std::nullopt};
    if (route_) place.along = route_->project(building.box().centre);
    return place;
  }

  void redraw(std::size_t i) {
    for (int attempt = 0; attempt < kPlacings; ++attempt) {
      const Building building = redraw_(i, buildings_, random_);
      const Place place = placeOf(building);
      if (!possible(i, place)) continue;
      buildings_[i] = building;
      places_[i] = place;
      return;
    }
  }

  bool possible(std::size_t i, const Place& place) const {
    const Place& truth = true_places_[i];
    if (keeps_ && route_ && place.along->offset * truth.along->offset < 0.0) return false;
    for (std::size_t j = 0; j < places_.size(); ++j) {
      if (j == i) continue;
      if (keeps_ && !sameOrder(place, truth, places_[j], true_places_[j])) return false;
      const Place& other = places_[j];
      if (place.bounds.overlaps(other.bounds) && overlap(place.footprint, other.footprint)) {
        return false;
      }
    }
    return !route_ || route_->distanceTo(place.footprint) >
                          std::min(kWay, route_->distanceTo(truth.footprint) / 2.0);
  }

  const Map& truth_;
  const Redraw& redraw_;
  bool keeps_;
  RandomStream random_;
  std::optional<Route> route_;
  std::vector<Place> true_places_;
  std::vector<Place> places_;
  std::vector<Building> buildings_;
};

double drawnSize(double size, double sigma_m, RandomStream& random) {
  const double least = std::min(3.0, size / 2.0);
  for (int i = 0; i < kPlacings; ++i) {
    const double drawn = random.normal(size, sigma_m);
    if (drawn >= least) return drawn;
  }
  return size;
}

}  // namespace

Map possibleDrawing(const Map& truth, const Redraw& redraw, std::uint64_t seed, Keeping keeping) {
  if (truth.buildings.size() > kMaxBuildings) {
    throwBadInput(phrase("buildings"), "", std::to_string(truth.buildings.size()),
                  phrase("at most {}", kMaxBuildings));
  }
  Map drawn = truth;
  drawn.buildings = Perturbation(truth, redraw, seed, keeping).draw();
  for (Building& building : drawn.buildings) {
    building.uncertainty.reset();
    building.estimate.reset();
  }
  drawn.whole = {};
  drawn.refinement.clear();
  return drawn;
}

Map perturbed(const Map& truth, double sigma_m, std::uint64_t seed, Keeping keeping) {
  const auto redraw = [&](std::size_t i, const std::vector<Building>&, RandomStream& random) {
    Rectangle box = truth.buildings[i].box();
    box.centre += sigma_m * Vec2(random.normals<2>().data());
    box.width = drawnSize(box.width, sigma_m, random);
    box.depth = drawnSize(box.depth, sigma_m, random);
    return truth.buildings[i].fitted(box);
  };
  Map drawn = possibleDrawing(truth, redraw, seed, keeping);
  drawn.uncertainty = {sigma_m, sigma_m};
  return drawn;
}

}  // namespace handmap
