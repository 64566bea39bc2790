#include "core/map/own_members.h"

#include <gtest/gtest.h>

#include "core/map/map_io.h"

namespace handmap {
namespace {

/// A file as the program writes it.
constexpr auto kWritten = R"({
  "format": "handmap",
  "version": 1,
  "start": {"x": 1, "y": 2, "heading_deg": 90},
  "uncertainty": {"position_m": 3, "size_m": 3},
  "buildings": [
    {"id": "A", "shape": "rectangle", "x": 0, "y": 0, "width": 10, "depth": 5, "heading_deg": 0, "estimate": {"sigma_x": 0.1, "sigma_y": 0.2, "sigma_width": 0.3, "observations": 4}, "doubtful": 0.25, "handmap:hidden": true, "handmap:locked": true, "handmap:may_not_exist": true, "mine": {"a":[1,2]}, "wall_sigma_m": [0.125,0.5,2,0.25], "walls_seen": [true,true,false,true]}
  ],
  "landmarks": [
    {"id": "L", "x": 3, "y": 4, "handmap:hidden": true}
  ],
  "underlays": [
    {"image": "a.png", "x": 0, "y": 0, "metres_per_pixel": 0.5, "heading_deg": 0, "opacity": 1, "handmap:locked": true}
  ],
  "handmap:layers": {"landmarks":{"hidden":true},"route":{"locked":true,"opacity":0.5}},
  "handmap:model": "yard.model.json",
  "handmap:start_uncertainty": {"heading_deg":12.5,"position_m":1.25},
  "somebody's": 7
}
)";

TEST(OwnMembers, AreFieldsAndComeBackToTheByte) {
  const Map map = parseMap(kWritten, "text");
  const Building& building = map.buildings[0];
  EXPECT_EQ(building.flags, (Flags{true, true}));
  EXPECT_TRUE(building.may_not_exist);
  EXPECT_EQ(building.doubt, 0.25);
  EXPECT_EQ(building.sides, (Sides{{{0.125, true}, {0.5, true}, {2.0, false}, {0.25, true}}}));
  EXPECT_EQ(building.unknown, (UnknownMembers{{"mine", R"({"a":[1,2]})"}}));
  EXPECT_TRUE(map.landmarks[0].flags.hidden);
  EXPECT_TRUE(map.underlays[0].flags.locked);
  EXPECT_TRUE(stateOf(map.layers, DrawingLayer::Landmarks).hidden);
  EXPECT_EQ(stateOf(map.layers, DrawingLayer::Route), (LayerState{false, true, 0.5}));
  EXPECT_EQ(map.model, "yard.model.json");
  ASSERT_TRUE(map.start_uncertainty);
  EXPECT_EQ(map.start_uncertainty->position, 1.25);
  EXPECT_EQ(map.unknown, (UnknownMembers{{"somebody's", "7"}}));
  EXPECT_EQ(formatMap(map), kWritten);
}

Map mapWith(const std::string& of_building, const std::string& of_map) {
  return parseMap(R"({"format":"handmap","version":1,"buildings":[{"id":"A","shape":"rectangle",)"
                  R"("x":0,"y":0,"width":2,"depth":1,"heading_deg":0)" +
                      of_building + "}]" + of_map + "}",
                  "text");
}

bool holds(const Map& map, const std::string& text) {
  return formatMap(map).find(text) != std::string::npos;
}

TEST(OwnMembers, WhatIsDamagedOrSaysMoreStaysAsItCame) {
  for (const char* member :
       {R"("doubtful": "much")", R"("doubtful": 5e-1)", R"("handmap:hidden": false)",
        R"("handmap:hidden": "yes")", R"("wall_sigma_m": [1,2])"}) {
    const Map map = mapWith(std::string(", ") + member, "");
    EXPECT_TRUE(holds(map, std::string(member).substr(0, 12))) << formatMap(map);
    EXPECT_EQ(parseMap(formatMap(map), "again"), map);
  }
  for (const char* member :
       {R"("handmap:model": 3)", R"("handmap:layers": {"walls":{"hidden":true}})",
        R"("handmap:layers": {"route":{"colour":"red","locked":true}})"}) {
    const Map map = mapWith("", std::string(", ") + member);
    EXPECT_TRUE(holds(map, member)) << formatMap(map);
    EXPECT_EQ(parseMap(formatMap(map), "again"), map);
  }
}

TEST(OwnMembers, AFieldTakesThePlaceOfWhatWasRead) {
  Map map = mapWith(R"(, "doubtful": "much", "handmap:hidden": true)",
                    R"(, "handmap:model": 3, "handmap:layers": {"route":{"locked":true,"a":1}})");
  map.buildings[0].doubt = 0.5;
  map.buildings[0].flags.hidden = false;
  map.model = "a.json";
  map.layers = {};
  EXPECT_TRUE(holds(map, R"("doubtful": 0.5)"));
  EXPECT_TRUE(holds(map, R"("handmap:model": "a.json")"));
  EXPECT_FALSE(holds(map, "hidden") || holds(map, "layers"));
  map = parseMap(formatMap(map), "again");
  map.buildings[0].doubt.reset();
  map.model.clear();
  EXPECT_FALSE(holds(map, "doubtful") || holds(map, "model"));
}

}  // namespace
}  // namespace handmap
