// Worlds to drive through: a true map, and what no one drew.
#pragma once

#include <cstdint>
#include <vector>

#include "core/map/map.h"

namespace handmap {

/// A round obstacle that is no building: a tree, a bush, a lamp post.
struct Obstacle {
  static constexpr double kBush_m = 0.7;  ///< a wider one is a bush: no trunk is like that

  Vec2 centre = Vec2::Zero();
  double radius = 0.0;
  double free_path_m = 0.0;  ///< how far a ray gets into it on average; 0: it is solid
};

/// What stands in a street and is drawn by no one: a parked car, a hedge, someone who stands there,
/// a traffic sign, a street lamp, a panel of a fence, a rack of bicycles.
struct Thing {
  enum class Kind { Car, Hedge, Person, Sign, Lamp, Fence, Rack };
  Kind kind = Kind::Car;
  /// A car, a person and a sign look along its heading; the arm of a lamp points there. Of a sign
  /// and a lamp the post.
  Rectangle footprint;
  double height = 0.0;
  double free_path_m = 0.0;  ///< as of an Obstacle
};

/// `map` has a start and a route for the robot.
struct World {
  Map map;
  std::vector<Obstacle> obstacles;
  std::vector<Thing> things;
  std::uint64_t seed = 0;  ///< of what things look like, see appearance.h
  /// What the buildings are like where a map does not go into such detail; none: as in the map.
  std::vector<Polygon> walls = {};
  std::size_t undrawn = 0;  ///< so many buildings, the last ones of the map, nobody draws

  /// The map without what nobody draws.
  Map drawable() const;

  Polygon wallsOf(std::size_t building) const {
    return walls.empty() ? map.buildings[building].footprint() : walls[building];
  }
};

/// The paper's kind of scene (Fig. 7): six buildings N1–N3, S1–S3 in two rows, 45–65 m wide, gaps
/// of 15–30 m, the robot between them. The same seed gives the same world.
World twoRowWorld(std::uint64_t seed);
/// Buildings of any heading, some L-shaped, on both sides of a route with turns.
World campusWorld(std::uint64_t seed);
/// A closed way of a kilometre around blocks of a campus, begun a second time: buildings with
/// courtyards, L-shaped ones and boxes on both sides, none quite in line.
World loopWorld(std::uint64_t seed);
/// A closed way like that of loopWorld, rough; the fronts stand 5–30 m from it.
World quarterWorld(std::uint64_t seed);
/// A residential street, straight or slightly bent: 12–18 detached houses 8–20 m wide, L1 … on the
/// left and R1 … on the right, gaps of 2–8 m, set back 4–8 m from the kerb; furnished.
World streetWorld(std::uint64_t seed);
/// Two rows of six houses wall to wall with a street between and an alley behind each, the way
/// around both: one row flush, the fronts of the other stepped by up to a metre.
World terraceWorld(std::uint64_t seed);
/// Any map with a route (or a start: the route then leads through between the buildings) becomes a
/// world. Throws BadInput where there is neither, or where the route is endless or runs through a
/// building.
World worldFromMap(const Map& map, std::uint64_t seed);
/// The world with parked cars beside the route, hedges before some buildings, lamps and signs at
/// the kerb, and people on the pavements and on the squares behind; nothing that was there before
/// changes.
World furnished(World world, std::uint64_t seed);
World withoutCars(World world, std::uint64_t seed);  ///< the same but for the cars
/// The world as real places are, furnished (without cars, unless they are there): recesses and bays
/// in long walls, fences before and between the buildings, bicycles at the walls, hedges and bushes
/// that are ragged and let part of the rays through. The map stays.
World rough(World world, std::uint64_t seed);

/// The world with sheds and garages before and beside the fronts, drawn by no one, and cars parked
/// along the fronts.
World withSheds(World world, std::uint64_t seed);

/// What a drawing keeps right about the places of its buildings, however wrong the measures are.
enum class Keeping { SideAndOrder, Nothing };

/// Whose errors a drawing has: each of the same σ and by itself (see perturbed()), or those that
/// people's drawings have (see drawnByPeople()).
enum class Like { Sigma, People };

/// The map as one remembers it: centre and width (and depth) of every building off by a normal
/// error of `sigma_m`; sizes stay positive, buildings do not come to overlap, neither each other
/// nor the route, and keep their side of the route and their order along it, unless they need not.
/// A building for which no such place is found stays where it is, and so does a fixed one. Throws
/// BadInput for more than 5,000 buildings.
Map perturbed(const Map& truth, double sigma_m, std::uint64_t seed,
              Keeping keeping = Keeping::SideAndOrder);

}  // namespace handmap
