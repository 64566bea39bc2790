// How well an outline explains the rays around it: a log likelihood ratio against nothing there.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/outlines/structure.h"

namespace handmap {

/// What a ray may be taken for, by what it meets and how that lies against the wall.
enum class Likeness : std::uint8_t { Wall, Askew, Along, Ragged, Low, Count };

/// log(1 − h Φ(z) + h r N(z; σ) / o) of a return z σ behind a wall: h the share of rays that a wall
/// stops, r how often it then looks as this one does, o how often other things along a metre do.
/// Tabulated over z and the ratio.
class ReturnTable {
 public:
  ReturnTable();
  float operator()(Likeness likeness, float z, float sigma_m) const;

 private:
  std::vector<float> table_;
};

/// By ray: which building its return is from, as far as that is settled.
using RayOwners = std::vector<int>;

/// The rays that can tell of an outline near a place.
class OutlineScorer {
 public:
  /// `owners`: empty where nothing is settled; returns of others than `building` are not from it.
  /// Outlines may move within `reach_m` around `centre`.
  OutlineScorer(const PlacedRays& placed, double range_limit_m, const RayOwners& owners,
                int building, const Vec2& centre, double reach_m);

  /// Tempered: rays share the errors of poses and walls. `slack_m`: how far walls may be off, one
  /// σ. `stride`: each so-manyth ray is asked.
  double operator()(const Polygon& outline, double slack_m, std::size_t stride = 1) const;
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
  std::size_t size() const { return rays_.size(); }

 private:
  struct Asked {
    PlacedRay ray;
    std::size_t index;  ///< of PlacedRays
    bool owned;         ///< by another building
  };
  struct Met {
    float distance;
    float cosine;
    float nx, ny;
    std::size_t wall;
  };
  template <typename Use>
  void forMet(const Polygon& outline, std::size_t stride, Use use) const;
  float ratioOf(const Asked& asked, const Met& met, float slack_m) const;

  struct Direction {
    float x, y;
  };
  struct Frame {
    Vec2 robot;       ///< where its rays come from
    std::size_t end;  ///< of its rays
  };
  std::vector<Asked> rays_;            ///< frame by frame
  std::vector<Direction> directions_;  ///< of the rays: most pass an outline by, which these tell
  std::vector<Frame> frames_;
  RayNoise noise_;
  float range_limit_m_;
  ReturnTable table_;
};

}  // namespace handmap
