// Recordings of rendered images: what is written, and that it can be used.
#include <fstream>

#include "tests/cli/program.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

class SimulateImages : public CliTest {
 protected:
  /// A short way between two buildings.
  SimulateImages() {
    writeText("way.handmap",
              R"({"format": "handmap", "version": 1, "route": [[0, 0], [10, 0]], "buildings": [
                  {"id": "A", "shape": "rectangle", "x": 5, "y": 14, "width": 30, "depth": 10,
                   "heading_deg": 0},
                  {"id": "B", "shape": "polygon", "vertices": [[-8, -20], [20, -20], [20, -9],
                   [5, -9], [5, -12], [-8, -12]]}]})");
  }

  static Outcome simulate(std::vector<std::string> more) {
    more.insert(more.begin(), {"simulate", "--images", "--world", "way.handmap", "--width", "160",
                               "--height", "120"});
    return run(more);
  }

  static std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
  }
};

TEST_F(SimulateImages, WritesPanoramasWithTheirTruth) {
  expectDone(simulate({"--labels", "--colour", "--out", "rec"}),
             "rec: 3 observations, truth.handmap and sketch.handmap of 2 buildings\n");
  for (const char* kind : {"image_0", "image_1", "labels", "depth"}) {
    EXPECT_EQ(filesIn(fs::path("rec") / kind), 18U) << kind;
    EXPECT_TRUE(fs::exists(fs::path("rec") / kind / "000002-6.png")) << kind;
  }
  const std::string label = contentOf("rec/labels/000000-1.png");
  const std::string depth = contentOf("rec/depth/000000-1.png");
  ASSERT_GT(std::min(label.size(), depth.size()), 100U);
  EXPECT_EQ(label[24], 8);  // bits a sample
  EXPECT_EQ(label[25], 0);  // grey
  EXPECT_EQ(depth[24], 16);
  EXPECT_EQ(depth[25], 0);
  EXPECT_EQ(contentOf("rec/image_0/000000-1.png")[25], 2);  // colour
  expectDone(run({"validate", "rec"}), "ok: rec: recording of 18 frames\n");
}

TEST_F(SimulateImages, AMovingRobotLooksAheadEveryMetre) {
  expectDone(simulate({"--moving", "--out", "rec"}),
             "rec: 11 observations, truth.handmap and sketch.handmap of 2 buildings\n");
  EXPECT_EQ(filesIn("rec/image_0"), 11U);
  EXPECT_FALSE(fs::exists("rec/labels"));
  EXPECT_FALSE(fs::exists("rec/points"));
  EXPECT_EQ(contentOf("rec/image_1/000010.png")[25], 0);
}

TEST_F(SimulateImages, TheSameSeedGivesTheSameBytes) {
  simulate({"--moving", "--clutter", "--seed", "4", "--out", "a"});
  simulate({"--moving", "--clutter", "--seed", "4", "--out", "b"});
  simulate({"--moving", "--clutter", "--seed", "5", "--out", "c"});
  for (const auto& entry : fs::recursive_directory_iterator("a")) {
    if (entry.is_directory()) continue;
    EXPECT_EQ(contentOf(entry.path()), contentOf("b" / fs::relative(entry.path(), "a")));
  }
  EXPECT_NE(contentOf("a/image_0/000003.png"), contentOf("c/image_0/000003.png"));
}

TEST_F(SimulateImages, ARunWorksOnThem) {
  simulate({"--out", "rec"});
  const Outcome outcome =
      run({"run", "--map", "rec/sketch.handmap", "--recording", "rec", "--source", "images"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("3 observations used, 0 skipped\n"), 0U) << outcome.out;
}

}  // namespace
}  // namespace handmap
