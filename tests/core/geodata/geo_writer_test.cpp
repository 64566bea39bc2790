#include "core/geodata/geo_writer.h"

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/geodata/geo_map.h"
#include "core/geodata/robot_map.h"
#include "core/map/public_tags.h"
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

class GeoWriter : public testing::Test {
 protected:
  std::filesystem::path out(const std::string& ending) const {
    return folder_.path() / ("map." + ending);
  }
  test::TemporaryFolder folder_;
};

TEST_F(GeoWriter, WhatGoesOutComesBack) {
  const Map map = corrected();
  for (const char* ending : {"geojson", "osm", "kml", "gpkg"}) {
    writeGeoMap(map, out(ending));
    const GeoMap back = readGeoMap(out(ending));
    ASSERT_EQ(back.map.buildings.size(), 2U) << ending;
    const Map& again = back.map;
    // Both frames are on the earth: through the degrees of one into the other.
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec2 size = Vec2(map.buildings[i].box().width, map.buildings[i].box().depth);
      const Building* found = nullptr;
      for (const Building& building : again.buildings) {
        if (std::abs(building.box().width * building.box().depth - size.prod()) < 1.0) {
          found = &building;
        }
      }
      EXPECT_TRUE(found) << ending;
    }
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

TEST_F(GeoWriter, RobotMapsComeBackWithinACell) {
  const Map map = corrected();
  writeGeoMap(map, out("yaml"));
  const std::string yaml = readFile(out("yaml"), 1 << 16);
  EXPECT_NE(yaml.find("resolution: 0.1\n"), std::string::npos);
  const Map back = readRobotMap(out("yaml"));
  ASSERT_EQ(back.buildings.size(), 2U);
  for (const Building& building : map.buildings) {
    double least = 1e9;
    for (const Building& again : back.buildings) {
      least = std::min(least, std::max(farthest(building.footprint(), again.footprint()),
                                       farthest(again.footprint(), building.footprint())));
    }
    EXPECT_LT(least, 0.25) << building.id;
  }
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
