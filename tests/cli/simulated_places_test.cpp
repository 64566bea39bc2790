// Drawings of simulated places that are as rough as real ones: README's figures, guarded.
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/map/map_io.h"
#include "core/report/report.h"
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

/// A quarter farther from the start than all is: it began where it is drawn.
TEST_F(SimulatedPlaces, ADrawingOfAnotherScale) {
  ASSERT_EQ(
      run({"simulate", "--scene", "quarter", "--laser", "--step", "2.5", "--out", "place"}).status,
      0);
  Map drawing = readMap("place/sketch.handmap");
  for (Building& building : drawing.buildings) {
    Rectangle box = building.box();
    box.centre = drawing.start->position() + 1.25 * (box.centre - drawing.start->position());
    box.width *= 1.25;
    box.depth *= 1.25;
    building.shape = box;
  }
  writeMap(drawing, "drawn.handmap");
  const Corrected corrected = correct("drawn.handmap");
  EXPECT_LT(corrected.drawn, 0.3);
  EXPECT_GT(corrected.refined, 0.7);
}

/// Sheds before the fronts, and no seam to be seen in one of them.
TEST_F(SimulatedPlaces, HousesWallToWall) {
  ASSERT_EQ(run({"simulate", "--scene", "terraces", "--laser", "--step", "2", "--sigma", "3",
                 "--sheds", "--seed", "13", "--out", "place"})
                .status,
            0);
  const Corrected corrected = correct("place/sketch.handmap");
  EXPECT_LT(corrected.drawn, 0.4);
  EXPECT_GT(corrected.refined, 0.75);
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

/// They tell the way, also where they come joined by the odometry.
TEST_F(SimulatedPlaces, TracksOfCornersAlone) {
  const std::vector<std::string> made{"simulate", "--scene", "two-rows",   "--clutter",
                                      "--sigma",  "5",       "--seed",     "1",
                                      "--out",    "place",   "--features", "50"};
  std::vector<std::string> joined = made;
  joined.insert(joined.end(), {"--joined", "40"});
  for (const auto& arguments : {made, joined}) {
    std::filesystem::remove_all("place");
    ASSERT_EQ(run(arguments).status, 0);
    const Corrected corrected = correct("place/sketch.handmap");
    EXPECT_LT(corrected.drawn, 0.6);
    EXPECT_GT(corrected.refined, corrected.drawn + 0.12);
    EXPECT_LT(corrected.way_m, 0.6);
  }
}

struct Verdicts {
  int said = 0;  ///< "it is off by no more than so much", with 95 % at least
  int right = 0;
};

/// How far a wall of what was found is from that side of the true building.
double offBy(const Rectangle& found, int side, const Rectangle& truth) {
  const auto wall = [](const Rectangle& box, std::size_t k) {
    const double heading = box.heading + 0.5 * kPi * static_cast<double>(k);
    const Vec2 outwards(std::cos(heading), std::sin(heading));
    return std::pair(Vec2(box.centre + 0.5 * (k % 2 == 0 ? box.width : box.depth) * outwards),
                     outwards);
  };
  const auto [at, outwards] = wall(found, static_cast<std::size_t>(side));
  double best = -2.0;
  double off_m = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [true_at, true_outwards] = wall(truth, k);
    if (outwards.dot(true_outwards) <= best) continue;
    best = outwards.dot(true_outwards);
    off_m = std::abs((at - true_at).dot(true_outwards));
  }
  return off_m;
}

/// What the table of a report says of the walls: within 0.3, 0.6, 1.2 m.
TEST_F(SimulatedPlaces, VerdictsOnWallsAreRight) {
  Verdicts verdicts;
  for (const auto& [scene, seed] : {std::pair("two-rows", "1"),
                                    {"campus", "2"},
                                    {"street", "1"},
                                    {"street", "2"},
                                    {"two-rows", "4"}}) {
    std::filesystem::remove_all("place");
    std::vector<std::string> made{"simulate", "--scene", scene,   "--seed", seed,
                                  "--sigma",  "3",       "--out", "place"};
    if (scene != std::string("two-rows")) made.emplace_back("--laser");
    ASSERT_EQ(run(made).status, 0);
    ASSERT_EQ(run({"run", "--map", "place/sketch.handmap", "--recording", "place", "--out",
                   "refined.handmap", "--quiet"})
                  .status,
              0);
    const Map truth = readMap("place/truth.handmap");
    const Map drawing = readMap("place/sketch.handmap");
    const Map refined = readMap("refined.handmap");
    for (const WallTolerance& wall : tolerancesOf(drawing, refined)) {
      const Building* found = refined.find(wall.building);
      const Building* real = truth.find(wall.building);
      ASSERT_TRUE(found && real);
      const double off_m = offBy(found->box(), wall.side, real->box());
      for (std::size_t i = 0; i < kTolerances_m.size(); ++i) {
        if (wall.within[i] < 0.95) continue;
        ++verdicts.said;
        verdicts.right += off_m <= kTolerances_m[i] ? 1 : 0;
      }
    }
  }
  EXPECT_GT(verdicts.said, 100);
  EXPECT_GE(verdicts.right, verdicts.said * 95 / 100) << "of " << verdicts.said;
}

}  // namespace
}  // namespace handmap
