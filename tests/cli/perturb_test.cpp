#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace handmap {
namespace {

class Perturb : public CliTest {
 protected:
  static std::string sketch(const std::string& sigma, const std::string& seed) {
    expectDone(run({"perturb", "--map", "row-truth.handmap", "--sigma", sigma, "--seed", seed,
                    "--out", "sketch.handmap"}),
               "");
    return contentOf("sketch.handmap");
  }
};

TEST_F(Perturb, FollowsFromTheSeed) {
  const std::string first = sketch("5", "7");
  EXPECT_EQ(first, sketch("5", "7"));
  EXPECT_NE(first, sketch("5", "8"));
  EXPECT_NE(first, sketch("6", "7"));
}

TEST_F(Perturb, MovesEveryBuildingAndTellsTheUncertainty) {
  const auto truth = nlohmann::json::parse(contentOf("row-truth.handmap"));
  const auto drawn = nlohmann::json::parse(sketch("5", "1"));
  EXPECT_EQ(drawn["uncertainty"]["position_m"], 5.0);
  EXPECT_EQ(drawn["start"], truth["start"]);
  ASSERT_EQ(drawn["buildings"].size(), truth["buildings"].size());
  for (std::size_t i = 0; i < truth["buildings"].size(); ++i) {
    EXPECT_EQ(drawn["buildings"][i]["id"], truth["buildings"][i]["id"]);
    EXPECT_NE(drawn["buildings"][i], truth["buildings"][i]);
  }
  expectDone(run({"validate", "sketch.handmap"}), "ok: sketch.handmap: map of 3 buildings\n");
}

TEST_F(Perturb, DrawsLikePeople) {
  const auto draw = [](const std::vector<std::string>& more) {
    std::vector<std::string> command = {"perturb", "--map", "row-truth.handmap", "--like",
                                        "people",  "--out", "sketch.handmap"};
    command.insert(command.end(), more.begin(), more.end());
    expectDone(run(command), "");
    return nlohmann::json::parse(contentOf("sketch.handmap"));
  };
  const auto drawn = draw({});
  EXPECT_EQ(drawn, draw({"--seed", "1"}));
  EXPECT_NE(drawn, draw({"--seed", "2"}));
  ASSERT_EQ(drawn["buildings"].size(), 3U);  // as many are drawn, however many are missed
  for (const auto& building : drawn["buildings"]) EXPECT_EQ(building["shape"], "rectangle");
  EXPECT_EQ(draw({"--sigma", "2"})["uncertainty"]["position_m"], 2.0);
}

TEST_F(Perturb, NeedsSigmaWhereItIsNotLikePeople) {
  expectFailed(run({"perturb", "--map", "row-truth.handmap", "--out", "sketch.handmap"}), 1,
               "handmap-cli: error: --sigma is required\n"
               "hint: handmap-cli perturb --help\n");
}

}  // namespace
}  // namespace handmap
