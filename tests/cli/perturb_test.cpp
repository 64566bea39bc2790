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

}  // namespace
}  // namespace handmap
