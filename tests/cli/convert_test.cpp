#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace handmap {
namespace {

using Convert = CliTest;

TEST_F(Convert, ThereAndBack) {
  auto map = nlohmann::json::parse(contentOf("row-truth.handmap"));
  map["georeference"] = {{"latitude", 34.7}, {"longitude", 137.4}};
  std::ofstream("placed.handmap") << map;
  expectDone(run({"convert", "placed.handmap", "placed.geojson"}), "");
  expectDone(run({"convert", "placed.geojson", "back.handmap"}), "");
  const auto back = nlohmann::json::parse(contentOf("back.handmap"));
  EXPECT_EQ(back["buildings"].size(), map["buildings"].size());
  EXPECT_TRUE(back.contains("georeference"));
  EXPECT_EQ(run({"validate", "back.handmap"}).status, 0);
}

TEST_F(Convert, SaysThatALargePlaceGetsCoarserCells) {
  auto map = nlohmann::json::parse(contentOf("row-truth.handmap"));
  map["route"] = {{0, 0}, {5000, 0}};
  std::ofstream("large.handmap") << map;
  const Outcome written = run({"convert", "large.handmap", "large.yaml"});
  EXPECT_EQ(written.status, 0);
  EXPECT_EQ(written.err,
            "large.yaml: in cells of 0.5 m: it is too large a place for a picture in cells of "
            "0.1 m\n");
  EXPECT_EQ(run({"convert", "large.yaml", "back.handmap"}).status, 0);
}

TEST_F(Convert, LaysTheMapOfARobotOnADrawing) {
  expectDone(run({"convert", "row-truth.handmap", "grid.yaml"}), "");
  const Outcome laid = run({"convert", "grid.yaml", "laid.handmap", "--onto", "row-drawn.handmap"});
  ASSERT_EQ(laid.status, 0) << laid.err;
  EXPECT_NE(laid.out.find("fits: yes\n"), std::string::npos) << laid.out;
  const auto drawing = nlohmann::json::parse(contentOf("laid.handmap"));
  ASSERT_EQ(drawing["underlays"].size(), 1U);
  EXPECT_EQ(drawing["underlays"][0]["image"], "grid.pgm");
  EXPECT_EQ(run({"validate", "laid.handmap"}).status, 0);
  expectDone(run({"convert", "laid.handmap", "town.fleet.yaml"}), "");
  EXPECT_NE(contentOf("town.fleet.yaml").find("rmf:"), std::string::npos);
  expectDone(run({"convert", "laid.handmap", "town.building.yaml"}), "");
  EXPECT_FALSE(exists(std::filesystem::path("town.building.pgm")));
  expectFailed(run({"convert", "row-truth.handmap", "a.fleet.yaml"}), 2,
               "handmap-cli: error: a.fleet.yaml: underlays: found 0 maps of robots, expected one, "
               "laid on the drawing\n");
}

TEST_F(Convert, SaysWhatItCannotDo) {
  expectFailed(run({"convert", "row-truth.handmap", "a.handmap"}), 1,
               "handmap-cli: error: row-truth.handmap to a.handmap: one of them is to be a drawing "
               "(.handmap)\nhint: handmap-cli convert --help\n");
  std::ofstream("empty.geojson") << R"({"type":"FeatureCollection","features":[]})";
  expectFailed(run({"convert", "empty.geojson", "a.handmap"}), 2,
               "handmap-cli: error: empty.geojson: found 0 features and no building among them, "
               "expected polygons of buildings\n");
}

}  // namespace
}  // namespace handmap
