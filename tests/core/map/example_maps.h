// Maps for the tests: a small one with everything in it, and random ones.
#pragma once

#include <cmath>
#include <string>

#include "core/base/random.h"
#include "core/map/map.h"

namespace handmap::test {

inline const std::string kFullMap = R"({
  "format": "handmap", "version": 1, "name": "Campus, drawn from memory",
  "start": { "x": 0.5, "y": -1.0, "heading_deg": 90.0, "said": "at the door" },
  "uncertainty": { "position_m": 2.5, "size_m": 1.5, "note": 1 },
  "buildings": [
    { "id": "N1", "name": "Library", "shape": "rectangle",
      "x": 10.0, "y": 25.0, "width": 40.0, "depth": 15.0, "heading_deg": 33.3,
      "uncertainty": { "position_m": 0.5, "size_m": 0.25, "why": "paced" }, "fixed": true,
      "estimate": { "sigma_x": 0.1, "sigma_y": 0.2, "sigma_width": 0.3, "observations": 12,
                    "kind": "swarm" },
      "storeys": 3, "colour": { "roof": "red" } },
    { "id": "N2", "shape": "polygon", "vertices": [[60,20],[95,20],[95,34],[60,34]], "x": "kept" }
  ],
  "landmarks": [ { "id": "gate", "name": "Main gate", "x": 0.0, "y": -3.0, "open": true } ],
  "route": [[0,0],[60,0],[60,40]],
  "underlays": [ { "image": "aerial.jpg", "x": -20, "y": 80, "metres_per_pixel": 0.2,
                   "heading_deg": 5, "opacity": 0.5, "source": "city" } ],
  "georeference": { "latitude": 34.70, "longitude": 137.41, "heading_deg": 10.0, "epoch": 2020 },
  "refinement": { "seed": 1, "recording": "street" },
  "author": "Ann", "tags": ["a", null, 1.5]
})";

/// Multiples of a step that files keep exactly.
inline double roundedUniform(RandomStream& random, double low, double high) {
  return std::round(random.uniform(low, high) * 1e6) / 1e6;
}

inline Building randomBuilding(RandomStream& random, int number) {
  Building building;
  building.id = "B" + std::to_string(number);
  if (random.index(2) == 0) building.name = "Name \"ü\\\n" + std::to_string(random());
  const Vec2 centre(roundedUniform(random, -1e5, 1e5), random.normal(0.0, 1e3));
  if (random.index(2) == 0) {
    building.shape = Rectangle{centre, random.uniform(0.1, 100.0), random.uniform(1e-3, 1e3),
                               toRadians(roundedUniform(random, -720.0, 720.0))};
  } else {  // star-shaped about its centre, counter-clockwise
    Polygon polygon;
    const int corners = 3 + random.index(9);
    for (int i = 0; i < corners; ++i) {
      polygon.push_back(centre + random.uniform(2.0, 30.0) * unitVector(2.0 * kPi * i / corners));
    }
    building.shape = polygon;
  }
  if (random.index(3) == 0) building.uncertainty = Uncertainty{random.uniform(), random.uniform()};
  building.fixed = random.index(4) == 0;
  if (random.index(3) == 0) {
    building.estimate = Estimate{random.uniform(), random.uniform(), 1e-7, random.index(100)};
  }
  if (random.index(3) == 0) building.unknown["storeys"] = std::to_string(random.index(9));
  if (random.index(3) == 0) building.unknown["a \"key\""] = R"({"x":[1,2.5,null]})";
  return building;
}

inline Map randomMap(RandomStream& random) {
  Map map;
  if (random.index(2) == 0) map.name = "Map " + std::to_string(random());
  if (random.index(2) == 0) {
    map.start =
        Pose2{random.normal(), random.normal(), toRadians(roundedUniform(random, -180.0, 180.0))};
  }
  map.uncertainty = {random.uniform(0.0, 50.0), random.uniform(0.0, 50.0)};
  const int buildings = random.index(8);
  for (int i = 0; i < buildings; ++i) map.buildings.push_back(randomBuilding(random, i));
  const int landmarks = random.index(3);
  for (int i = 0; i < landmarks; ++i) {
    map.landmarks.push_back({"L" + std::to_string(i), "", {random.normal(), random.normal()}, {}});
  }
  const int corners = random.index(5);
  for (int i = 0; i < corners; ++i) map.route.emplace_back(random.normal(), random.normal());
  if (random.index(2) == 0) {
    map.underlays.push_back({"photo.png",
                             random.normal(),
                             random.normal(),
                             random.uniform(0.1, 2),
                             toRadians(roundedUniform(random, 0, 360)),
                             random.uniform(),
                             {}});
  }
  if (random.index(2) == 0) {
    map.georeference = Georeference{random.uniform(-80, 80),
                                    random.uniform(-180, 180),
                                    toRadians(roundedUniform(random, 0, 360)),
                                    {}};
  }
  if (random.index(2) == 0) map.refinement = R"({"recording":"street","seed":1})";
  if (random.index(2) == 0) map.unknown["zz"] = "[1,[2,{}]]";
  return map;
}

}  // namespace handmap::test
