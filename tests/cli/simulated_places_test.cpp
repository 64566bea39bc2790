// Drawings of simulated places that are as rough as real ones: README's figures, guarded.
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace handmap {
namespace {

class SimulatedPlaces : public CliTest {
 protected:
  struct Corrected {
    double drawn;  ///< mean IoU
    double refined;
    double way_m;  ///< rms, aligned
  };

  static nlohmann::json compared(const std::string& map) {
    const Outcome outcome = run({"compare", map, "place/truth.handmap", "--trajectory", "way.tum",
                                 "--truth", "place/truth.tum", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }

  static Corrected correct(const std::string& drawing) {
    const Outcome done = run({"run", "--map", drawing, "--recording", "place", "--out",
                              "refined.handmap", "--trajectory", "way.tum"});
    EXPECT_EQ(done.status, 0) << done.err;
    const nlohmann::json drawn = compared(drawing);
    const nlohmann::json refined = compared("refined.handmap");
    return {drawn["as_it_is"]["mean"]["iou"], refined["as_it_is"]["mean"]["iou"],
            refined["trajectory"]["aligned_rms_m"]};
  }
};

TEST_F(SimulatedPlaces, ARoughQuarterByLaser) {
  ASSERT_EQ(
      run({"simulate", "--scene", "quarter", "--laser", "--step", "2.5", "--out", "place"}).status,
      0);
  const Corrected corrected = correct("place/sketch.handmap");
  EXPECT_LT(corrected.drawn, 0.5);
  EXPECT_GT(corrected.refined, 0.8);
  EXPECT_LT(corrected.way_m, 0.3);
}

TEST_F(SimulatedPlaces, ARoughCampusWhoseDrawnCornersAreWrong) {
  ASSERT_EQ(
      run({"simulate", "--scene", "campus", "--rough", "--seed", "2", "--out", "place"}).status, 0);
  ASSERT_EQ(run({"perturb", "--map", "place/truth.handmap", "--sigma", "4", "--corners", "0.8",
                 "--simplify", "2", "--seed", "7", "--out", "drawn.handmap"})
                .status,
            0);
  const Corrected corrected = correct("drawn.handmap");
  EXPECT_LT(corrected.drawn, 0.55);
  EXPECT_GT(corrected.refined, corrected.drawn + 0.15);
  EXPECT_LT(corrected.way_m, 1.0);
}

}  // namespace
}  // namespace handmap
