#include "core/map/map_io.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "tests/core/base/comma_locale.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/map/example_maps.h"

namespace handmap {
namespace {

using test::kFullMap;

TEST(MapIo, ReadsEverything) {
  const Map map = parseMap(kFullMap, "m");
  EXPECT_EQ(map.name, "Campus, drawn from memory");
  EXPECT_EQ(map.start, (Pose2{0.5, -1.0, toRadians(90.0)}));
  EXPECT_EQ(map.uncertainty, (Uncertainty{2.5, 1.5}));
  ASSERT_EQ(map.buildings.size(), 2u);
  const Building& library = map.buildings[0];
  EXPECT_EQ(library.id, "N1");
  EXPECT_EQ(library.name, "Library");
  EXPECT_EQ(std::get<Rectangle>(library.shape), (Rectangle{{10, 25}, 40, 15, toRadians(33.3)}));
  EXPECT_EQ(library.uncertainty, (Uncertainty{0.5, 0.25}));
  EXPECT_TRUE(library.fixed);
  EXPECT_EQ(library.estimate, (Estimate{0.1, 0.2, 0.3, 12}));
  const Building& other = map.buildings[1];
  EXPECT_EQ(other.name, "");
  EXPECT_FALSE(other.fixed || other.uncertainty || other.estimate);
  EXPECT_EQ(std::get<Polygon>(other.shape), (Polygon{{60, 20}, {95, 20}, {95, 34}, {60, 34}}));
  ASSERT_EQ(map.landmarks.size(), 1u);
  EXPECT_EQ(map.landmarks[0].name, "Main gate");
  EXPECT_EQ(map.landmarks[0].position, Vec2(0, -3));
  EXPECT_EQ(map.route, (std::vector<Vec2>{{0, 0}, {60, 0}, {60, 40}}));
  ASSERT_EQ(map.underlays.size(), 1u);
  EXPECT_EQ(map.underlays[0].image, "aerial.jpg");
  EXPECT_EQ(map.underlays[0].metres_per_pixel, 0.2);
  EXPECT_EQ(map.underlays[0].heading, toRadians(5));
  EXPECT_EQ(map.underlays[0].opacity, 0.5);
  ASSERT_TRUE(map.georeference);
  EXPECT_EQ(map.georeference->latitude, 34.7);
  EXPECT_EQ(map.georeference->longitude, 137.41);
  EXPECT_EQ(map.georeference->heading, toRadians(10));
  EXPECT_EQ(map.refinement, R"({"recording":"street","seed":1})");
}

TEST(MapIo, NeedsOnlyFormatVersionAndBuildings) {
  const Map map = parseMap(R"({"format": "handmap", "version": 1, "buildings": []})", "m");
  EXPECT_EQ(map, Map{});
  EXPECT_EQ(map.uncertainty, (Uncertainty{3.0, 3.0}));
  EXPECT_FALSE(map.start);
}

TEST(MapIo, TellsHowTrueTheDrawingIsAsAWhole) {
  const std::string begin = R"({"format": "handmap", "version": 1, "buildings": [], )";
  EXPECT_EQ(parseMap(begin + R"("uncertainty": {"size_m": 1}})", "m").whole, WholeUncertainty{});
  const Map scaled = parseMap(begin + R"("uncertainty": {"scale": 0}})", "m");
  EXPECT_EQ(scaled.whole.scale, 0.0);
  EXPECT_FALSE(scaled.whole.turn);
  const Map map = parseMap(
      begin + R"("uncertainty": {"turn_deg": 0.3, "shift_m": 6, "scale": 0.02, "source": "air"}})",
      "m");
  EXPECT_EQ(map.whole, (WholeUncertainty{0.02, toRadians(0.3), 6.0}));
  EXPECT_EQ(map.uncertainty, Uncertainty{});
  const std::string text = formatMap(map);
  EXPECT_NE(text.find(R"("scale": 0.02, "turn_deg": 0.3, "shift_m": 6)"), std::string::npos)
      << text;
  EXPECT_EQ(parseMap(text, "m"), map);
}

TEST(MapIo, KeepsUnknownMembersAtEveryLevel) {
  const Map map = parseMap(kFullMap, "m");
  EXPECT_EQ(map.unknown.at("author"), "\"Ann\"");
  EXPECT_EQ(map.unknown.at("tags"), R"(["a",null,1.5])");
  EXPECT_EQ(map.buildings[0].unknown.at("colour"), R"({"roof":"red"})");
  EXPECT_EQ(map.buildings[1].unknown.at("x"), "\"kept\"");
  EXPECT_EQ(map.landmarks[0].unknown.at("open"), "true");
  EXPECT_EQ(map.underlays[0].unknown.at("source"), "\"city\"");
  EXPECT_EQ(map.georeference->unknown.at("epoch"), "2020");
  const std::string written = formatMap(map);
  for (const char* kept :
       {R"("author": "Ann")", R"("tags": ["a",null,1.5])", R"("storeys": 3)",
        R"("said":"at the door")", R"("note":1)", R"("why":"paced")", R"("kind":"swarm")",
        R"("x": "kept")", R"("open": true)", R"("source": "city")", R"("epoch": 2020)"}) {
    EXPECT_NE(written.find(kept), std::string::npos) << kept;
  }
  EXPECT_EQ(parseMap(written, "again"), map);
  EXPECT_EQ(formatMap(parseMap(written, "again")), written);
}

TEST(MapIo, UnknownMembersOfAPartGoWithIt) {
  Map map = parseMap(kFullMap, "m");
  map.start.reset();
  map.buildings[0].estimate.reset();
  const Map again = parseMap(formatMap(map), "again");
  EXPECT_FALSE(again.start);
  EXPECT_FALSE(again.buildings[0].estimate);
}

TEST(MapIo, AnUnknownMemberDoesNotDoubleAKnownOne) {
  Map map = parseMap(kFullMap, "m");
  // The polygon had an unknown "x"; as a rectangle it has one of its own.
  map.buildings[1].shape = Rectangle{{1, 2}, 3, 4, 0};
  const Map again = parseMap(formatMap(map), "again");
  EXPECT_EQ(std::get<Rectangle>(again.buildings[1].shape).centre, Vec2(1, 2));
}

TEST(MapIo, StoresPolygonsCounterClockwiseAndOpen) {
  const auto polygon = [](const std::string& vertices) {
    const Map map = parseMap(R"({"format":"handmap","version":1,"buildings":[
        {"id":"A","shape":"polygon","vertices":)" +
                                 vertices + "}]}",
                             "m");
    return std::get<Polygon>(map.buildings[0].shape);
  };
  const Polygon expected = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  EXPECT_EQ(polygon("[[0,0],[4,0],[4,3],[0,3]]"), expected);
  EXPECT_EQ(polygon("[[0,0],[0,3],[4,3],[4,0]]"), expected);
  EXPECT_EQ(polygon("[[0,0],[4,0],[4,0],[4,3],[0,3],[0,0]]"), expected);
}

TEST(MapIo, WritesALineForEachBuilding) {
  const std::string text = formatMap(parseMap(kFullMap, "m"));
  EXPECT_TRUE(text.starts_with("{\n  \"format\": \"handmap\",\n  \"version\": 1,\n  \"name\": "));
  EXPECT_TRUE(text.ends_with("\n}\n"));
  EXPECT_NE(
      text.find("\n    {\"id\": \"N1\", \"name\": \"Library\", \"shape\": \"rectangle\", "
                "\"x\": 10, \"y\": 25, \"width\": 40, \"depth\": 15, \"heading_deg\": 33.3, "),
      std::string::npos);
  EXPECT_NE(text.find("\n    {\"id\": \"N2\", \"shape\": \"polygon\", "
                      "\"vertices\": [[60, 20], [95, 20], [95, 34], [60, 34]], "),
            std::string::npos);
}

TEST(MapIo, RandomMapsComeBackWithTheSameBytes) {
  RandomStream random(11);
  for (int i = 0; i < 300; ++i) {
    const Map map = test::randomMap(random);
    const std::string text = formatMap(map);
    const Map again = parseMap(text, "m");
    ASSERT_EQ(formatMap(again), text);
    ASSERT_EQ(parseMap(text, "m"), again);
    ASSERT_EQ(again.buildings.size(), map.buildings.size());
    for (std::size_t k = 0; k < map.buildings.size(); ++k)
      ASSERT_LT((again.buildings[k].box().centre - map.buildings[k].box().centre).norm(), 5e-3);
  }
}

TEST(MapIo, WritesMillimetresAndThousandthsOfADegree) {
  Map map;
  map.start = Pose2{1.23456, -0.0004, toRadians(12.3456)};
  Building building;
  building.id = "A";
  building.shape = Rectangle{{1.0 / 3.0, 2e5 + 0.12349}, 20.00049, 1e-4, toRadians(-0.00049)};
  map.buildings = {building};
  building.id = "B";
  building.shape = Polygon{{0.12345, 0}, {10, 0.0006}, {0, 9.9999}};
  map.buildings.push_back(building);
  map.route = {{0.1, 0.2}, {1.0 / 7.0, 3}};
  const std::string text = formatMap(map);
  for (const char* part :
       {R"("start": {"x": 1.235, "y": 0, "heading_deg": 12.346})",
        R"("x": 0.333, "y": 200000.123, "width": 20, "depth": 0.0001, "heading_deg": 0})",
        R"("vertices": [[0.123, 0], [10, 0.001], [0, 10]])",
        R"("route": [[0.1, 0.2], [0.143, 3]])"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
}

TEST(MapIo, AnOutlineThatMillimetresWouldBreakIsWrittenWhole) {
  Map map;
  Building building;
  building.id = "A";
  building.shape = Polygon{{0, 0}, {10, 0}, {10, 0.0002}, {5, 0.0002}, {5, 9}, {0, 9}};
  map.buildings = {building};
  const Map again = parseMap(formatMap(map), "m");
  EXPECT_EQ(again, map);
}

TEST(MapIo, AnyHeadingIsStableAfterTheFirstWriting) {
  RandomStream random(12);
  Map map;
  for (int i = 0; i < 1000; ++i) {
    const double heading = random.normal(0.0, 10.0);
    map.start = Pose2{0, 0, heading};
    const std::string text = formatMap(map);
    const Map again = parseMap(text, "m");
    ASSERT_NEAR(again.start->heading, heading, toRadians(0.00051));
    ASSERT_EQ(formatMap(again), text);
  }
  map.start = Pose2{0, 0, 1e6 + 0.5};  // beyond what is read: turned back
  EXPECT_NEAR(normalizedAngle(parseMap(formatMap(map), "m").start->heading - 1e6), 0.5, 1e-5);
}

TEST(MapIo, EqualMapsGiveEqualBytes) {
  Map map = parseMap(kFullMap, "m");
  Map negative_zero = map;
  map.landmarks[0].position.x() = 0.0;
  negative_zero.landmarks[0].position.x() = -0.0;
  ASSERT_EQ(map, negative_zero);
  EXPECT_EQ(formatMap(map), formatMap(negative_zero));
}

TEST(MapIo, DoesNotFollowTheLocale) {
  const std::string expected = formatMap(parseMap(kFullMap, "m"));
  const test::CommaLocale comma;
  const Map map = parseMap(kFullMap, "m");
  EXPECT_EQ(map.uncertainty.position, 2.5);
  EXPECT_EQ(formatMap(map), expected);
  EXPECT_NE(formatGeoJson(map).find("137.41"), std::string::npos);
}

TEST(MapIo, WritesFilesThatReadBack) {
  const test::TemporaryFolder folder;
  const Map map = parseMap(kFullMap, "m");
  const auto path = folder.path() / "campus.handmap";
  writeMap(map, path);
  EXPECT_EQ(readMap(path), map);
  EXPECT_EQ(folder.read("campus.handmap"), formatMap(map));
}

TEST(MapIo, AnEstimateThatKnowsLessThanAFileMaySayIsWrittenAsTheMost) {
  Map map = parseMap(kFullMap, "full");
  map.buildings[0].estimate = Estimate{1e9, 0.2, 104'403.0, 12};
  EXPECT_EQ(parseMap(formatMap(map), "again").buildings[0].estimate, (Estimate{1e5, 0.2, 1e5, 12}));
}

TEST(MapIo, WhatCouldNotBeReadAgainIsNotWritten) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("campus.handmap", "old");
  Map map = parseMap(kFullMap, "m");
  map.buildings[1].id = "N1";
  test::expectBadInput([&] { writeMap(map, path); }, {path.string(), "buildings[1].id", "N1"});
  map.buildings[1].id = "N2";
  map.start->x = std::nan("");
  test::expectError(ErrorCode::RunFailed, [&] { writeMap(map, path); }, {"not finite"});
  EXPECT_EQ(folder.read("campus.handmap"), "old");
}

TEST(MapIo, ReadsTheRealDrawings) {
  const std::filesystem::path street = std::filesystem::path(HANDMAP_SHARED_DATA) / "street";
  if (!std::filesystem::exists(street)) GTEST_SKIP() << "no data in " << street;
  const Map truth = readMap(street / "truth.handmap");
  EXPECT_EQ(truth.buildings.size(), 19u);
  EXPECT_NE(truth.find("L4"), nullptr);
  for (const auto& [name, count] :
       {std::pair{"sketch-a", 19u}, std::pair{"sketch-b", 19u}, std::pair{"sketch-c", 16u}}) {
    const Map map = readMap(street / (std::string(name) + ".handmap"));
    EXPECT_EQ(map.buildings.size(), count);
    EXPECT_TRUE(map.start);
    EXPECT_EQ(formatMap(parseMap(formatMap(map), "again")), formatMap(map));
  }
}

}  // namespace
}  // namespace handmap
