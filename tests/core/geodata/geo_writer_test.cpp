#include "core/geodata/geo_writer.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "core/base/text.h"
#include "core/geodata/geo_map.h"
#include "core/geodata/robot_map.h"
#include "core/map/map_io.h"
#include "core/map/public_tags.h"
#include "core/map/tangent_plane.h"
#include "core/map/underlay_fit.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

Map corrected() {
  Map map;
  Building library;
  library.id = "N1";
  library.name = "Library <old> & new";
  library.shape = Rectangle{{10.0, 25.0}, 40.0, 16.0, 0.3};
  library.estimate = Estimate{0.2, 0.3, 0.4, 7};
  Building hall;
  hall.id = "4711";
  hall.shape = Polygon{{60, 20}, {95, 20}, {95, 34}, {70, 34}, {70, 50}, {60, 50}};
  keepTags({"way", "4711", {{"building", "school"}, {"height", "12"}, {"note", "a \"b\""}}}, hall);
  map.buildings = {library, hall};
  map.georeference = Georeference{34.7, 137.41, 0.2, {}};
  return map;
}

double farthest(const Polygon& a, const Polygon& b) {
  double most = 0.0;
  for (const Vec2& p : a) {
    double least = 1e9;
    for (const Vec2& q : b) least = std::min(least, (p - q).norm());
    most = std::max(most, least);
  }
  return most;
}

/// Of corners, each from the nearest of the other map, metres; each map lies about its own origin.
double apartOnEarth(const Map& map, const Map& other) {
  const TangentPlane here(*map.georeference);
  const TangentPlane there(*other.georeference);
  std::vector<Polygon> moved;
  for (const Building& building : other.buildings) {
    Polygon& outline = moved.emplace_back(building.footprint());
    for (Vec2& corner : outline) corner = here.inMap(there.longitudeLatitude(corner));
  }
  double most = 0.0;
  for (const Building& building : map.buildings) {
    double least = 1e9;
    for (const Polygon& outline : moved) {
      const Polygon own = building.footprint();
      least = std::min(least, std::max(farthest(own, outline), farthest(outline, own)));
    }
    most = std::max(most, least);
  }
  return most;
}

class GeoWriter : public testing::Test {
 protected:
  std::filesystem::path out(const std::string& ending) const {
    return folder_.path() / ("map." + ending);
  }
  test::TemporaryFolder folder_;
};

TEST_F(GeoWriter, WhatGoesOutComesBack) {
  const Map map = corrected();
  // OpenStreetMap has seven digits behind the point of a degree.
  for (const auto& [ending, apart_m] :
       {std::pair("geojson", 2e-4), {"osm", 0.011}, {"kml", 1e-6}, {"gpkg", 1e-6}}) {
    writeGeoMap(map, out(ending));
    const GeoMap back = readGeoMap(out(ending));
    ASSERT_EQ(back.map.buildings.size(), 2U) << ending;
    EXPECT_LT(apartOnEarth(map, back.map), apart_m) << ending;
  }
}

TEST_F(GeoWriter, KeepsIdsAndTagsOfAPublicMap) {
  for (const char* ending : {"osm", "geojson"}) {
    writeGeoMap(corrected(), out(ending));
    const GeoMap back = readGeoMap(out(ending));
    const Building* hall = back.map.find("4711");
    ASSERT_TRUE(hall) << ending;
    const PublicTags tags = tagsOf(*hall);
    EXPECT_EQ(tags.osm_type, "way");
    EXPECT_EQ(tags.osm_id, "4711");
    EXPECT_EQ(tags.tags.at("building"), "school") << ending;
    EXPECT_EQ(tags.tags.at("height"), "12");
    EXPECT_EQ(tags.tags.at("note"), "a \"b\"");
  }
  const std::string osm = formatOsm(corrected());
  EXPECT_NE(osm.find("<way id=\"4711\" visible=\"true\" action=\"modify\">"), std::string::npos);
  EXPECT_NE(osm.find("Library &lt;old&gt; &amp; new"), std::string::npos);
  EXPECT_NE(osm.find("k=\"handmap:sigma_x\" v=\"0.20\""), std::string::npos);
}

TEST_F(GeoWriter, ARelationStaysOne) {
  Map map = corrected();
  keepTags({"relation", "77", {{"building", "yes"}, {"type", "multipolygon"}, {"name", "Court"}}},
           map.buildings[0]);
  writeGeoMap(map, out("osm"));
  const GeoMap back = readGeoMap(out("osm"));
  ASSERT_EQ(back.map.buildings.size(), 2U);
  const Building* court = back.map.find("77");
  ASSERT_TRUE(court);
  const PublicTags tags = tagsOf(*court);
  EXPECT_EQ(tags.osm_type, "relation");
  EXPECT_EQ(tags.tags.at("name"), "Court");
  const std::string osm = formatOsm(map);
  EXPECT_NE(osm.find("<relation id=\"77\" visible=\"true\" action=\"modify\">"), std::string::npos);
}

TEST_F(GeoWriter, PlansAreInMetresOfTheMap) {
  Map map = corrected();
  map.georeference.reset();
  writeGeoMap(map, out("dxf"));
  const std::string dxf = readFile(out("dxf"), 1 << 22);
  EXPECT_NE(dxf.find("BUILDINGS"), std::string::npos);
  EXPECT_NE(dxf.find("LWPOLYLINE"), std::string::npos);
  EXPECT_NE(dxf.find("95"), std::string::npos);
  test::expectBadInput([&] { writeGeoMap(map, out("kml")); }, {"georeference"});
  test::expectBadInput([&] { writeGeoMap(map, out("doc")); }, {"map.doc", "dxf"});
  EXPECT_FALSE(std::filesystem::exists(out("kml")));
}

TEST_F(GeoWriter, PlansComeBack) {
  Map map = corrected();
  writeGeoMap(map, out("dxf"));
  const Map back = readGeoMap(out("dxf")).map;
  EXPECT_FALSE(back.georeference);
  ASSERT_EQ(back.buildings.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(farthest(map.buildings[i].footprint(), back.buildings[i].footprint()), 1e-6);
  }
  EXPECT_EQ(back.buildings[0].name, "Library <old> & new");
  const std::string dxf = readFile(out("dxf"), 1 << 22);
  const auto cut = folder_.write("cut.dxf", dxf.substr(0, dxf.size() / 4));
  test::expectBadInput([&] { readGeoMap(cut); }, {"cut.dxf"});
  test::expectBadInput([&] { readGeoMap(folder_.write("no.dxf", "<html>")); }, {"no.dxf"});
}

/// Of corners, each building from the nearest of the other map, metres.
double apart(const Map& map, const Map& other) {
  double most = 0.0;
  for (const Building& building : map.buildings) {
    double least = 1e9;
    for (const Building& again : other.buildings) {
      least = std::min(least, std::max(farthest(building.footprint(), again.footprint()),
                                       farthest(again.footprint(), building.footprint())));
    }
    most = std::max(most, least);
  }
  return most;
}

TEST_F(GeoWriter, RobotMapsComeBackWithinACell) {
  const Map map = corrected();
  writeGeoMap(map, out("yaml"));
  const std::string yaml = readFile(out("yaml"), 1 << 16);
  EXPECT_NE(yaml.find("resolution: 0.1\n"), std::string::npos);
  const Map back = readRobotMap(out("yaml"));
  ASSERT_EQ(back.buildings.size(), 2U);
  EXPECT_LT(apart(map, back), 0.25);
}

TEST_F(GeoWriter, ALargePlaceGetsCoarserCells) {
  Map map = corrected();
  map.buildings[0].shape = Rectangle{{-4000.0, 25.0}, 40.0, 16.0, 0.3};
  EXPECT_EQ(robotMapCell(map, "m.yaml"), 0.5);
  writeGeoMap(map, out("yaml"));
  EXPECT_NE(readFile(out("yaml"), 1 << 16).find("resolution: 0.5\n"), std::string::npos);
  const Map back = readRobotMap(out("yaml"));
  ASSERT_EQ(back.buildings.size(), 2U);
  EXPECT_LT(apart(map, back), 2.5 * 0.5);

  map.buildings[0].shape = Rectangle{{-900'000.0, 25.0}, 40.0, 16.0, 0.3};
  writeFileAtomically(out("yaml"), "as it was");
  test::expectBadInput([&] { writeGeoMap(map, out("yaml")); }, {"cells of 10 m", "20000"});
  EXPECT_EQ(readFile(out("yaml"), 1 << 16), "as it was");
}

TEST_F(GeoWriter, WhereTheTextCannotBeWrittenThePictureStays) {
  folder_.write("map.pgm", "as it was");
  std::filesystem::create_directory(out("yaml"));
  EXPECT_THROW(writeGeoMap(corrected(), out("yaml")), Error);
  EXPECT_EQ(folder_.read("map.pgm"), "as it was");
  EXPECT_FALSE(exists(folder_.path() / "map.pgm.part"));
}

TEST_F(GeoWriter, AGridIsReadInAllItsModes) {
  const auto grid = [&](const std::string& more, const std::vector<int>& pixels) {
    std::string pgm = "P5\n4 2\n255\n";
    for (const int pixel : pixels) pgm += static_cast<char>(pixel);
    folder_.write("g.pgm", pgm);
    return readRobotGrid(
        folder_.write("g.yaml",
                      "image: g.pgm\nresolution: 0.5\norigin: [1, 2, 1.5707963267948966]\n"
                      "occupied_thresh: 0.65\nfree_thresh: 0.196\n" +
                          more));
  };
  // Black above on the left; the lower left corner is the origin, turned to the left.
  const RobotGrid trinary = grid("negate: 0\n", {0, 205, 254, 254, 254, 254, 254, 254});
  ASSERT_EQ(trinary.ground.edges.size(), 1U);
  EXPECT_LT((trinary.ground.edges[0] - Vec2(1.0 - 0.75, 2.0 + 0.25)).norm(), 1e-9);
  EXPECT_EQ(trinary.ground.free.size(), 6U);
  const RobotGrid negated = grid("negate: 1\n", {255, 50, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(negated.ground.edges, trinary.ground.edges);
  EXPECT_EQ(negated.ground.free.size(), 6U);
  const RobotGrid raw = grid("negate: 0\nmode: raw\n", {100, 255, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(raw.ground.edges, trinary.ground.edges);
  EXPECT_EQ(raw.ground.free.size(), 6U);

  const Pose2 place{10.0, -5.0, 0.7};
  const Underlay underlay = underlayOf(raw, place);
  const Vec2 pixel = pointOf(underlay, {0.5, 0.5});
  EXPECT_LT((pixel - place.toOuter(raw.ground.edges[0])).norm(), 1e-9);
  EXPECT_LT((pointOf(underlay, {0, 2}) - place.toOuter({1.0, 2.0})).norm(), 1e-9);

  test::expectBadInput([&] { grid("mode: colourful\n", {0}); }, {"g.yaml", "mode", "trinary"});
  test::expectBadInput([&] { grid("", {254, 254, 254, 254, 254, 254, 254, 254}); }, {"g.yaml"});
}

TEST_F(GeoWriter, FleetsGetTheSameWalls) {
  Map map = corrected();
  map.landmarks.push_back({"gate", "Gate: \"A\"", {0.0, -3.0}});
  const auto file = folder_.path() / "town.building.yaml";
  writeGeoMap(map, file);
  const YAML::Node node = YAML::LoadFile(file.string());
  EXPECT_EQ(node["coordinate_system"].as<std::string>(), "cartesian_meters");
  const YAML::Node level = node["levels"]["L1"];
  const auto vertex = [&](const YAML::Node& index) {
    const YAML::Node at = level["vertices"][index.as<std::size_t>()];
    return Vec2(at[0].as<double>(), at[1].as<double>());
  };
  std::size_t wall = 0;
  for (const Building& building : map.buildings) {
    const Polygon outline = building.footprint();
    for (std::size_t i = 0; i < outline.size(); ++i, ++wall) {
      EXPECT_LT((vertex(level["walls"][wall][0]) - outline[i]).norm(), 1e-4);
      EXPECT_LT((vertex(level["walls"][wall][1]) - outline[(i + 1) % outline.size()]).norm(), 1e-4);
    }
  }
  EXPECT_EQ(level["walls"].size(), wall);
  EXPECT_EQ(level["vertices"].size(), wall + 1);
  EXPECT_EQ(level["vertices"][wall][3].as<std::string>(), "Gate: \"A\"");
  EXPECT_EQ(level["lanes"].size(), 0U);
}

TEST_F(GeoWriter, FleetsGetPairsOfPoints) {
  Map map = corrected();
  const auto file = folder_.path() / "town.fleet.yaml";
  test::expectBadInput([&] { writeGeoMap(map, file); }, {"town.fleet.yaml", "0 maps of robots"});
  writeRobotMap(map, out("yaml"));
  const Pose2 place{3.0, -4.0, 1.1};
  map.underlays.push_back(underlayOf(readRobotGrid(out("yaml")), place));
  writeMap(map, folder_.path() / "m.handmap");  // it is kept
  writeGeoMap(readMap(folder_.path() / "m.handmap"), file);
  const YAML::Node level = YAML::LoadFile(file.string())["reference_coordinates"]["L1"];
  ASSERT_EQ(level["rmf"].size(), 4U);
  ASSERT_EQ(level["robot"].size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto at = [&](const char* key) {
      return Vec2(level[key][i][0].as<double>(), level[key][i][1].as<double>());
    };
    EXPECT_LT((place.toOuter(at("robot")) - at("rmf")).norm(), 1e-3);
  }
  map.underlays.push_back(map.underlays[0]);
  test::expectBadInput([&] { writeGeoMap(map, file); }, {"2 maps of robots"});
}

TEST_F(GeoWriter, DamagedRobotMapsAreRefused) {
  writeGeoMap(corrected(), out("yaml"));
  const std::string yaml = readFile(out("yaml"), 1 << 16);
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string text = yaml;
    text.replace(text.find(from), from.size(), to);
    const auto path = folder_.write("bad.yaml", text);
    test::expectBadInput([&] { readRobotMap(path); }, {"bad"});
  };
  refused("map.pgm", "../bad.pgm");
  refused("0.1", "-1");
  refused("[", "{");
  const std::string pgm = readFile(out("pgm"), 1 << 24);
  folder_.write("bad.pgm", pgm.substr(0, pgm.size() / 2));
  refused("map.pgm", "bad.pgm");
  folder_.write("bad.pgm", "P5\n99999999 99999999\n255\n");
  refused("map.pgm", "bad.pgm");
}

TEST(PublicTagsOf, ArePackedByGdal) {
  std::map<std::string, std::string> tags;
  addPackedTags(R"("a"=>"1","b \"c\""=>"d\\e","f"=>)", tags);
  EXPECT_EQ(tags.at("a"), "1");
  EXPECT_EQ(tags.at("b \"c\""), "d\\e");
}

}  // namespace
}  // namespace handmap
