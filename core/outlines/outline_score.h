// How well an outline explains the rays around it: a log likelihood ratio against nothing there.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/outlines/structure.h"

namespace handmap {

/// What a return may be from, by what it meets and how that lies against the wall.
/// Through: it got so far, or is from another building.
enum class Likeness : std::uint8_t { Wall, Askew, Along, Ragged, Low, Through, Silent };

/// By ray: which building its return is from, as far as that is settled.
using RayOwners = std::vector<int>;

/// The rays that can tell of an outline near a place.
class OutlineScorer {
 public:
  /// `owners`: empty where nothing is settled; returns of others than `building` are not from it.
  /// Outlines may move within `reach_m` around `centre`.
  OutlineScorer(const PlacedRays& placed, double range_limit_m, const RayOwners& owners,
                int building, const Vec2& centre, double reach_m);

  /// It asks about so many of the rays at most, for all of them.
  OutlineScorer thinned(std::size_t most) const;

  struct Evidence {
    double nats = 0.0;     ///< for the outline
    double against = 0.0;  ///< of them, by walls that speak against it; at most 0
  };
  /// Tempered: rays share the errors of poses and walls. `slack_m`: how far walls may be off, one
  /// σ.
  Evidence evidence(const Polygon& outline, double slack_m) const;
  double operator()(const Polygon& outline, double slack_m) const {
    return evidence(outline, slack_m).nats;
  }
  /// The same by wall that rays meet (i: from corner i − 1 to corner i), but for robots inside.
  std::vector<double> ofWalls(const Polygon& outline, double slack_m) const;
  /// Tempered number of returns that are from each wall (i: from corner i − 1 to corner i).
  std::vector<double> returnsOf(const Polygon& outline, double slack_m) const;
  /// The same of the sides of a box that is turned by `heading`, as box() has them.
  std::array<double, 4> returnsOfSides(const Polygon& outline, double heading,
                                       double slack_m) const;
  /// A return that is near a wall which its ray enters by. Small: of a long drive there are
  /// millions, for each place that a building may have.
  struct Standing {
    std::uint32_t ray;    ///< index of PlacedRays
    float ratio;          ///< what it says for the outline
    double nats() const;  ///< the same, tempered
  };
  /// Those within `near_m`; by ray.
  std::vector<Standing> standingFor(const Polygon& outline, double near_m) const;
  /// How many frames have such returns.
  int framesStandingFor(const Polygon& outline, double near_m) const;

 private:
  OutlineScorer(const RangeNoise& noise, float range_limit_m)
      : noise_(noise), range_limit_m_(range_limit_m) {}

  struct Asked {
    float range;
    float share;
    float nx, ny;           ///< across what is straight or linear
    std::uint32_t index;    ///< of PlacedRays
    Likeness along, askew;  ///< to a wall that lies along that, and to others
    bool tall;
    bool owned;  ///< by another building
  };
  /// Some of the rays that meet the outline, within the range limit.
  struct Met {
    template <typename T>
    using Each = std::array<T, outlines::kBlock>;

    std::size_t size;
    Each<std::uint32_t> ray;
    Each<float> range, distance, cosine;
    Each<float> nx, ny;  ///< of the wall, outwards
    Each<std::uint32_t> wall;

    /// How far the return is behind the wall, across it.
    double behind(std::size_t k) const {
      return static_cast<double>((range[k] - distance[k]) * cosine[k]);
    }
  };
  template <typename Use>
  void forMet(const Polygon& outline, Use use) const;
  /// What each tells for the outline.
  Met::Each<float> ratiosOf(const Met& met, double slack_m) const;

  std::vector<Asked> rays_;
  std::vector<float> x_, y_, dx_, dy_;  ///< where the rays come from and go
  std::vector<Vec2> robots_;            ///< of the frames
  double each_ = 1.0;                   ///< how many one that is asked about stands for
  RangeNoise noise_;
  float range_limit_m_;
};

}  // namespace handmap
