// What rays meet in a world: walls, things, plants. Metres, map frame.
#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/simulation/ray_cast.h"
#include "core/simulation/world.h"

namespace handmap {

/// `direction` is a unit vector on the ground; the ray climbs `rise` metres a metre from `height`.
struct SensorRay {
  Vec2 origin;
  Vec2 direction;
  double height = 0.0;
  double rise = 0.0;

  double heightAt(double distance) const { return height + rise * distance; }
};

struct Hit {
  enum class On { Wall, Thing, Plant };
  double distance = kNoHit;  ///< on the ground
  On on = On::Wall;
};

class Surroundings {
 public:
  explicit Surroundings(const World& world);

  /// What of it may be met from a place.
  Surroundings within(double reach_m, const Vec2& eye) const;
  /// The first surface; what lets rays through stops them by chance.
  Hit cast(const SensorRay& ray, RandomStream& random) const;

 private:
  struct Wall {
    Segment at;
    double top_m;
  };
  struct Body {
    Polygon corners;
    double top_m;
    double free_path_m;
  };

  Surroundings() = default;

  std::vector<Wall> walls_;
  std::vector<Body> bodies_;
  std::vector<Obstacle> plants_;
};

}  // namespace handmap
