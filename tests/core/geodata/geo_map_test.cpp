#include "core/geodata/geo_map.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/map/map_io.h"

namespace handmap {
namespace {

class GeoMapTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  static std::string complaintOf(const std::filesystem::path& path) {
    try {
      readGeoMap(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::BadInput);
      return error.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() /
      ("handmap-geo-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

Map campus() {
  Map map;
  Building library;
  library.id = "N1";
  library.name = "Library";
  library.shape = Rectangle{{10.0, 25.0}, 40.0, 16.0, 0.3};
  Building hall;
  hall.id = "N2";
  hall.shape = Polygon{{60, 20}, {95, 20}, {95, 34}, {70, 34}, {70, 50}, {60, 50}};
  hall.uncertainty = Uncertainty{1.5, 2.5};
  map.buildings = {library, hall};
  map.landmarks = {{"gate", "Main gate", {0.0, -3.0}}};
  map.route = {{0, 0}, {60, 0}, {60, 10}};
  map.georeference = Georeference{34.7, 137.41, 0.0, {}};
  return map;
}

TEST_F(GeoMapTest, OpensWhatTheProgramItselfExports) {
  const Map map = campus();
  const GeoMap back = readGeoMap(write("campus.geojson", formatGeoJson(map)));
  EXPECT_EQ(back.left_out, 0u);
  ASSERT_EQ(back.map.buildings.size(), 2u);
  EXPECT_EQ(back.map.buildings[0].id, "N1");
  EXPECT_EQ(back.map.buildings[0].name, "Library");
  EXPECT_EQ(back.map.buildings[1].uncertainty, (Uncertainty{1.5, 2.5}));
  ASSERT_EQ(back.map.landmarks.size(), 1u);
  EXPECT_EQ(back.map.landmarks[0].name, "Main gate");
  ASSERT_EQ(back.map.route.size(), 3u);
  ASSERT_TRUE(back.map.georeference);
  EXPECT_NEAR(back.map.georeference->latitude, 34.7, 0.001);
  // All as it was, about another origin.
  const Vec2 shift = back.map.landmarks[0].position - map.landmarks[0].position;
  for (std::size_t b = 0; b < 2; ++b) {
    const Polygon was = map.buildings[b].footprint();
    const Polygon is = back.map.buildings[b].footprint();
    ASSERT_EQ(is.size(), was.size());
    for (std::size_t i = 0; i < was.size(); ++i) EXPECT_LT((is[i] - was[i] - shift).norm(), 0.01);
  }
  // And where it was on earth.
  EXPECT_EQ(readGeoMap(write("again.geojson", formatGeoJson(back.map))).map.buildings.size(), 2u);
}

TEST_F(GeoMapTest, TakesTheBuildingsOfOpenStreetMap) {
  const GeoMap geo = readGeoMap(write("town.osm", R"(<?xml version="1.0"?>
<osm version="0.6" generator="a person">
 <node id="1" lat="52.0" lon="13.0"/> <node id="2" lat="52.0" lon="13.0003"/>
 <node id="3" lat="52.0002" lon="13.0003"/> <node id="4" lat="52.0002" lon="13.0"/>
 <node id="5" lat="52.001" lon="13.001"/> <node id="6" lat="52.001" lon="13.002"/>
 <node id="7" lat="52.002" lon="13.002"/>
 <way id="10"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/>
  <tag k="building" v="yes"/><tag k="name" v="Rathaus"/></way>
 <way id="11"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="5"/><tag k="landuse" v="grass"/></way>
</osm>)"));
  ASSERT_EQ(geo.map.buildings.size(), 1u) << "grass is no building";
  EXPECT_EQ(geo.map.buildings[0].name, "Rathaus");
  EXPECT_EQ(geo.map.buildings[0].id, "10");
  const Rectangle box = geo.map.buildings[0].box();
  EXPECT_NEAR(std::max(box.width, box.depth), 22.3, 0.1);
  EXPECT_NEAR(std::min(box.width, box.depth), 20.6, 0.1);
  EXPECT_LT(box.centre.norm(), 0.01) << "the origin is in the middle";
  EXPECT_NEAR(geo.map.georeference->longitude, 13.00015, 1e-9);
  EXPECT_EQ(geo.map.whole.scale, 0.0);
}

/// As editors write them.
TEST_F(GeoMapTest, TakesNodesOfOpenStreetMapInAnyOrder) {
  const GeoMap geo = readGeoMap(write("unsorted.osm", R"(<?xml version="1.0"?>
<osm version="0.6" generator="an editor">
 <node id="9" lat="52.0" lon="13.0"/> <node id="2" lat="52.0" lon="13.0003"/>
 <node id="8" lat="52.0002" lon="13.0003"/> <node id="4" lat="52.0002" lon="13.0"/>
 <way id="10"><nd ref="9"/><nd ref="2"/><nd ref="8"/><nd ref="4"/><nd ref="9"/>
  <tag k="building" v="yes"/></way>
</osm>)"));
  EXPECT_EQ(geo.map.buildings.size(), 1u);
}

TEST_F(GeoMapTest, TakesEveryPolygonWhereNoKindIsTold) {
  const GeoMap geo = readGeoMap(write("areas.geojson", R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"name":"A"},"geometry":{"type":"MultiPolygon","coordinates":
 [[[[13,52],[13.001,52],[13.001,52.001],[13,52]]],[[[13.002,52],[13.003,52],[13.003,52.001],[13.002,52]]]]}},
{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":
 [[[13,52.01],[13.001,52.011],[13.001,52.01],[13,52.011],[13,52.01]]]}}]})"));
  EXPECT_EQ(geo.map.buildings.size(), 2u);
  EXPECT_EQ(geo.map.buildings[1].name, "A");
  EXPECT_EQ(geo.left_out, 1u) << "it crosses itself";
}

TEST_F(GeoMapTest, LeavesNothingBesideWhatItReads) {
  const GeoMap geo = readGeoMap(write("town.GML", R"(<?xml version="1.0"?>
<ogr:FeatureCollection xmlns:ogr="http://ogr.maptools.org/" xmlns:gml="http://www.opengis.net/gml">
<gml:featureMember><ogr:b fid="b.0"><ogr:geometryProperty><gml:Polygon srsName="EPSG:4326">
<gml:outerBoundaryIs><gml:LinearRing><gml:coordinates>9,45 9.001,45 9.001,45.001 9,45
</gml:coordinates></gml:LinearRing></gml:outerBoundaryIs></gml:Polygon></ogr:geometryProperty>
</ogr:b></gml:featureMember></ogr:FeatureCollection>)"));
  EXPECT_EQ(geo.map.buildings.size(), 1u);
  const std::filesystem::directory_iterator files(folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

/// In the metres of a country, far from its origin.
TEST_F(GeoMapTest, APlanOfAFarPlaceIsMoved) {
  const GeoMap geo =
      readGeoMap(write("plan.dxf",
                       "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nWALLS\n90\n4\n70\n1\n"
                       "10\n4512000.5\n20\n5401000\n10\n4512020.5\n20\n5401000\n"
                       "10\n4512020.5\n20\n5401010\n10\n4512000.5\n20\n5401010\n"
                       "0\nENDSEC\n0\nEOF\n"));
  ASSERT_EQ(geo.map.buildings.size(), 1u);
  const Rectangle box = geo.map.buildings[0].box();
  EXPECT_NEAR(box.width * box.depth, 200.0, 1e-6);
  EXPECT_LT(box.centre.norm(), 1.0);
}

TEST_F(GeoMapTest, SaysWhatIsWrong) {
  const std::string torn = complaintOf(write("torn.geojson", "{\n\"type\": \"Featu"));
  EXPECT_NE(torn.find("torn.geojson: line 2"), std::string::npos) << torn;
  const std::string none = complaintOf(
      write("points.geojson",
            R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
      "geometry":{"type":"Point","coordinates":[13,52]}}]})"));
  EXPECT_NE(none.find("1 features and no building"), std::string::npos) << none;
  const std::string metres = complaintOf(
      write("metres.geojson",
            R"({"type":"Polygon","coordinates":[[[500,900],[600,900],[600,950],[500,900]]]})"));
  EXPECT_NE(metres.find("500"), std::string::npos) << metres;
  EXPECT_NE(complaintOf(folder_ / "gone.osm").find("gone.osm"), std::string::npos);
}

TEST(GeoFiles, AreKnownByTheirEnding) {
  EXPECT_TRUE(isGeoFile("a/b.GeoJSON"));
  EXPECT_TRUE(isGeoFile("b.osm"));
  EXPECT_FALSE(isGeoFile("b.handmap"));
  EXPECT_FALSE(isGeoFile("osm"));
}

}  // namespace
}  // namespace handmap
