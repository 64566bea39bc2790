#include "core/outlines/joint_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/outlines/constants.h"
#include "core/outlines/mode_choice.h"

namespace handmap {

using namespace outlines;

namespace {

using Standing = std::vector<OutlineScorer::Standing>;

/// What returns that both claim say for the one for which they say less; both by ray.
double sharedNats(const Standing& one, const Standing& other) {
  double shared = 0.0;
  auto b = other.begin();
  for (const OutlineScorer::Standing& claim : one) {
    while (b != other.end() && b->ray < claim.ray) ++b;
    if (b == other.end()) break;
    if (b->ray == claim.ray) shared += std::max(0.0, std::min(claim.nats(), b->nats()));
  }
  return shared;
}

/// Of the smaller one's area.
double overlapCost(const Polygon& one, const Polygon& other) {
  const double least = std::min(std::abs(signedArea(one)), std::abs(signedArea(other)));
  return kOverlap * sharedArea(one, other) / std::max(1.0, least);
}

struct Region {
  Vec2 centre;
  double reach_m;
};

Region regionOf(const OutlinePrior& prior) {
  const Bounds bounds = boundsOf(prior.start);
  const double radius = 0.5 * (bounds.high - bounds.low).norm();
  return {0.5 * (bounds.low + bounds.high), 1.4 * radius + 2.5 * prior.shift_m};
}

class Places {
 public:
  Places(const std::vector<OutlinePrior>& priors, const PlacedRays& placed, double range_limit_m,
         const RayOwners& owners, std::uint64_t seed, std::stop_token stop)
      : priors_(priors),
        placed_(placed),
        range_limit_m_(range_limit_m),
        owners_(owners),
        seed_(seed),
        stop_(std::move(stop)),
        modes_(priors.size()) {}

  void search() {
    parallelFor(priors_.size(), [&](std::size_t i) {
      if (stop_.stop_requested()) return;
      const OutlineScorer scorer = scorerOf(i, owners_);
      for (FittedOutline& place : searchOutlines(priors_[i], scorer, random(i), stop_)) {
        add(i, std::move(place), scorer);
      }
    });
  }

  void searchBesideRivals() {
    struct Beside {
      std::size_t building, rival;
      std::vector<FittedOutline> places;
    };
    std::vector<Beside> beside;
    for (const auto& [i, m, k, n, cost] : conflictsAmong(1)) {
      if (cost < kTells) continue;
      beside.push_back({i, k, {}});
      beside.push_back({k, i, {}});
    }
    parallelFor(beside.size(), [&](std::size_t b) {
      auto& [i, rival, places] = beside[b];
      if (!stop_.stop_requested()) places = placesBeside(i, rival);
    });
    if (stop_.stop_requested()) return;
    for (auto& [i, rival, places] : beside) {
      for (FittedOutline& place : places) add(i, std::move(place), scorerOf(i, owners_));
    }
  }

  /// First which thing each building is, then where on that it stands.
  std::vector<std::optional<FittedOutline>> choose() const {
    const std::vector<ModeConflict> conflicts = conflictsAmong();
    const std::vector<int> things = chosen(conflicts, tellsWhichThing);
    const std::vector<int> modes = chosen(conflicts, tellsWhere, things);
    std::vector<std::optional<FittedOutline>> places(priors_.size());
    for (std::size_t i = 0; i < priors_.size(); ++i) {
      if (modes[i] != kNoMode) places[i] = modeOf(i, modes[i]).place;
    }
    return places;
  }

 private:
  struct Mode {
    FittedOutline place;
    Standing standing;
  };
  /// What the evidence tells for a place, some nats taken off.
  using Told = double (*)(const FittedOutline&, double);
  /// The same of where on one thing the building stands.
  static double tellsWhere(const FittedOutline& place, double less) { return place.score - less; }

  const Mode& modeOf(std::size_t i, int mode) const {
    return modes_[i][static_cast<std::size_t>(mode)];
  }

  /// `things`: modes of the things that buildings stand on; any where empty or kNoMode.
  std::vector<int> chosen(std::vector<ModeConflict> conflicts, Told told,
                          const std::vector<int>& things = {}) const {
    std::vector<std::vector<double>> worth(priors_.size());
    for (std::size_t i = 0; i < priors_.size(); ++i) {
      for (const Mode& mode : modes_[i]) {
        const bool may =
            things.empty() || things[i] == kNoMode || areOfOneThing(modeOf(i, things[i]), mode);
        worth[i].push_back(may ? told(mode.place, 0.0) + mode.place.prior
                               : -std::numeric_limits<double>::infinity());
      }
    }
    for (ModeConflict& conflict : conflicts) {
      const auto lost = [&](const Mode& mode) {
        return told(mode.place, 0.0) - told(mode.place, conflict.cost);
      };
      conflict.cost = std::min(lost(modes_[conflict.building][conflict.mode]),
                               lost(modes_[conflict.other][conflict.other_mode]));
    }
    return chooseModes(worth, conflicts);
  }

  /// Most of what either explains.
  static bool areOfOneThing(const Mode& one, const Mode& other) {
    const double less = std::min(sharedNats(one.standing, one.standing),
                                 sharedNats(other.standing, other.standing));
    return sharedNats(one.standing, other.standing) >= 0.5 * less;
  }

  RandomStream random(std::size_t i) const {
    return RandomStream(seed_, static_cast<std::uint32_t>(i));
  }
  OutlineScorer scorerOf(std::size_t i, const RayOwners& owners) const {
    return scorerFor(priors_[i], placed_, range_limit_m_, owners, static_cast<int>(i));
  }
  void add(std::size_t i, FittedOutline place, const OutlineScorer& scorer) {
    Standing standing = scorer.standingFor(place.outline, kOwnedWithin_m);
    modes_[i].push_back({std::move(place), std::move(standing)});
  }

  /// Where the best place of the rival has the returns of its own.
  std::vector<FittedOutline> placesBeside(std::size_t i, std::size_t rival) const {
    RayOwners owners = owners_;
    for (const OutlineScorer::Standing& claim : modes_[rival].front().standing) {
      owners[claim.ray] = static_cast<int>(rival);
    }
    std::vector<FittedOutline> places =
        searchOutlines(priors_[i], scorerOf(i, owners), random(i), stop_);
    const OutlineScorer scorer = scorerOf(i, owners_);
    for (FittedOutline& place : places) scorePlace(place, scorer);
    return places;
  }

  /// Of the first so many modes of each.
  std::vector<ModeConflict> conflictsAmong(
      std::size_t most = std::numeric_limits<std::size_t>::max()) const {
    std::vector<ModeConflict> conflicts;
    for (std::size_t i = 0; i < priors_.size() && !stop_.stop_requested(); ++i) {
      const Region here = regionOf(priors_[i]);
      for (std::size_t k = i + 1; k < priors_.size(); ++k) {
        const Region there = regionOf(priors_[k]);
        if ((here.centre - there.centre).norm() > here.reach_m + there.reach_m) continue;
        for (std::size_t m = 0; m < std::min(most, modes_[i].size()); ++m) {
          for (std::size_t n = 0; n < std::min(most, modes_[k].size()); ++n) {
            const Mode& one = modes_[i][m];
            const Mode& other = modes_[k][n];
            const double cost = sharedNats(one.standing, other.standing) +
                                overlapCost(one.place.outline, other.place.outline);
            if (cost > 0.0) conflicts.push_back({i, m, k, n, cost});
          }
        }
      }
    }
    return conflicts;
  }

  const std::vector<OutlinePrior>& priors_;
  const PlacedRays& placed_;
  double range_limit_m_;
  const RayOwners& owners_;
  std::uint64_t seed_;
  std::stop_token stop_;
  std::vector<std::vector<Mode>> modes_;  ///< by building
};

}  // namespace

double sharedArea(const Polygon& outline, const Polygon& other) {
  return boundsOf(outline).overlaps(boundsOf(other)) ? intersectionArea(outline, other) : 0.0;
}

OutlineScorer scorerFor(const OutlinePrior& prior, const PlacedRays& placed, double range_limit_m,
                        const RayOwners& owners, int building) {
  const auto [centre, reach_m] = regionOf(prior);
  return {placed, range_limit_m, owners, building, centre, reach_m};
}

std::vector<std::optional<FittedOutline>> placesTogether(
    const std::vector<OutlinePrior>& priors, const PlacedRays& placed, double range_limit_m,
    const RayOwners& owners, std::uint64_t seed, const std::stop_token& stop) {
  Places places(priors, placed, range_limit_m, owners, seed, stop);
  places.search();
  places.searchBesideRivals();
  return places.choose();
}

}  // namespace handmap
