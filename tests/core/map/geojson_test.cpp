#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/map/map_io.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/map/example_maps.h"

namespace handmap {
namespace {

using nlohmann::json;

json exported(const Map& map) { return json::parse(formatGeoJson(map)); }

TEST(GeoJson, NeedsAGeoreference) {
  test::expectBadInput([] { formatGeoJson(Map{}); }, {"georeference"});
}

TEST(GeoJson, HasAFeatureForEachObject) {
  const json collection = exported(parseMap(test::kFullMap, "m"));
  EXPECT_EQ(collection.at("type"), "FeatureCollection");
  const json& features = collection.at("features");
  ASSERT_EQ(features.size(), 4u);
  for (const json& feature : features) EXPECT_EQ(feature.at("type"), "Feature");
  EXPECT_EQ(features[0]["geometry"]["type"], "Polygon");
  EXPECT_EQ(features[2]["geometry"]["type"], "Point");
  EXPECT_EQ(features[3]["geometry"]["type"], "LineString");
  EXPECT_EQ(features[3]["geometry"]["coordinates"].size(), 3u);
  EXPECT_EQ(features[2]["properties"]["id"], "gate");
  const json& library = features[0]["properties"];
  EXPECT_EQ(library["id"], "N1");
  EXPECT_EQ(library["name"], "Library");
  EXPECT_EQ(library["sigma_position_m"], 0.5);
  EXPECT_EQ(library["sigma_size_m"], 0.25);
  EXPECT_EQ(library["estimate_sigma_x_m"], 0.1);
  EXPECT_EQ(library["estimate_observations"], 12);
  EXPECT_EQ(features[1]["properties"]["sigma_position_m"], 2.5);  // that of the map
  EXPECT_FALSE(features[1]["properties"].contains("estimate_sigma_x_m"));
}

TEST(GeoJson, RingsAreClosedAndCounterClockwise) {
  RandomStream random(21);
  for (int i = 0; i < 100; ++i) {
    Map map = test::randomMap(random);
    map.georeference =
        Georeference{random.uniform(-70, 70), random.uniform(-170, 170), random.uniform(-4, 4), {}};
    const json collection = exported(map);
    for (std::size_t b = 0; b < map.buildings.size(); ++b) {
      const json& ring = collection["features"][b]["geometry"]["coordinates"][0];
      EXPECT_EQ(ring.front(), ring.back());
      ASSERT_EQ(ring.size(), map.buildings[b].footprint().size() + 1);
      Polygon polygon;  // in units of 1e-9 degrees about its first corner
      for (const json& p : ring) {
        polygon.emplace_back((p[0].get<double>() - ring[0][0].get<double>()) * 1e9,
                             (p[1].get<double>() - ring[0][1].get<double>()) * 1e9);
      }
      EXPECT_GT(signedArea(polygon), 0.0);
    }
  }
}

// Lengths of a degree on WGS 84, from published tables (metres): at the equator 110574.3 of
// latitude and 111319.5 of longitude, at 45° 111131.7 and 78846.8, at 60° 111412.2 and 55800.0.
TEST(GeoJson, LiesRightOnTheEllipsoid) {
  struct Case {
    double latitude;
    double metres_of_latitude;
    double metres_of_longitude;
  };
  for (const Case& c : {Case{0.0, 110574.3, 111319.5}, Case{45.0, 111131.7, 78846.8},
                        Case{60.0, 111412.2, 55800.0}}) {
    Map map;
    map.georeference = Georeference{c.latitude, 10.0, 0.0, {}};
    map.landmarks.push_back({"east", "", {c.metres_of_longitude / 100.0, 0.0}, {}});
    map.landmarks.push_back({"north", "", {0.0, c.metres_of_latitude / 100.0}, {}});
    const json features = exported(map)["features"];
    const json& east = features[0]["geometry"]["coordinates"];
    const json& north = features[1]["geometry"]["coordinates"];
    EXPECT_NEAR(east[0].get<double>(), 10.01, 2e-8);
    EXPECT_NEAR(east[1].get<double>(), c.latitude, 1e-9);
    EXPECT_NEAR(north[0].get<double>(), 10.0, 1e-9);
    EXPECT_NEAR(north[1].get<double>(), c.latitude + 0.01, 2e-8);
  }
}

TEST(GeoJson, TurnsByTheHeadingOfTheMap) {
  Map map;
  map.georeference = Georeference{0.0, 0.0, kPi / 2.0, {}};  // the map's x axis points north
  map.landmarks.push_back({"ahead", "", {100.0, 0.0}, {}});
  const json point = exported(map)["features"][0]["geometry"]["coordinates"];
  EXPECT_NEAR(point[0].get<double>(), 0.0, 1e-9);
  EXPECT_NEAR(point[1].get<double>(), 100.0 / 110574.3, 1e-8);
}

}  // namespace
}  // namespace handmap
