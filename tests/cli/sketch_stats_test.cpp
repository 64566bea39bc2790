#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace handmap {
namespace {

class SketchStats : public CliTest {
 protected:
  SketchStats() {
    writeMap("true.handmap", {{0, 0, 20}, {60, 0, 10}, {0, 50, 15}, {70, 60, 30}});
    writeMap("ann.handmap", {{3, 1, 18}, {52, 4, 12}, {2, 44, 15}, {66, 51, 24}});
    writeMap("ben.handmap", {{-4, 2, 19}, {61, -6, 11}, {5, 57, 13}, {78, 62, 27}});
  }

  struct House {
    int x, y, size;
  };
  static void writeMap(const std::string& path, const std::vector<House>& houses) {
    nlohmann::json map = {{"format", "handmap"}, {"version", 1}};
    for (const House& house : houses) {
      map["buildings"].push_back(
          {{"id", std::string(1, static_cast<char>('A' + map["buildings"].size()))},
           {"shape", "rectangle"},
           {"x", house.x},
           {"y", house.y},
           {"width", house.size},
           {"depth", house.size},
           {"heading_deg", 0}});
    }
    writeText(path, map.dump());
  }
};

TEST_F(SketchStats, TellHowPeopleDraw) {
  expectDone(run({"sketch-stats", "ann.handmap", "ben.handmap", "--reference", "true.handmap"}),
             contentOf(std::filesystem::path(HANDMAP_CLI_EXPECTED) / "sketch-stats.txt"));
  const Outcome outcome =
      run({"sketch-stats", "ann.handmap", "--reference", "true.handmap", "--json", "--seed", "2"});
  EXPECT_EQ(outcome.status, 0);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["drawings"][0]["placed"], 4);
  EXPECT_LT(json["figures"]["size_slope"]["value"], 1.0);
  EXPECT_FALSE(json.contains("places_foretold"));
}

TEST_F(SketchStats, NeedThreePlaces) {
  writeMap("two.handmap", {{0, 0, 20}, {60, 0, 10}});
  expectFailed(run({"sketch-stats", "two.handmap", "--reference", "true.handmap"}), 2,
               "handmap-cli: error: two.handmap: found fewer than three places of the true map, "
               "expected three or more\n");
}

}  // namespace
}  // namespace handmap
