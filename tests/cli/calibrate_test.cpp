#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/core/calibration/rendered_boards.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

using Calibrate = CliTest;

std::vector<std::string> calibrateWith(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"calibrate", "--left", "left",  "--right",  "right",
                                     "--square",  "0.04",   "--out", "calib.yml"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST_F(Calibrate, FromBoardsToARecordingThatOpens) {
  test::writeBoards(".", test::boardCamera(), test::variedPoses());
  fs::copy(fs::path(HANDMAP_TEST_DATA) / "tiles-160x96.png", "left/none.png");
  const Outcome outcome = run(calibrateWith({"--board", "9x6", "--report", "report.json"}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("12 pairs used, 1 refused\nbaseline 0.1"), 0U) << outcome.out;
  EXPECT_NE(outcome.err.find("handmap-cli: none refused: no image of that name in the right "
                             "folder\n"),
            std::string::npos)
      << outcome.err;
  const auto report = nlohmann::json::parse(contentOf("report.json"));
  EXPECT_NEAR(report["baseline_m"], 0.12, 0.001);
  EXPECT_EQ(report["refused"][0]["name"], "none");

  fs::remove("left/none.png");
  writeText("recording.json", R"({"format": "handmap-recording", "version": 1,
      "camera": {"calibration": "calib.yml", "rectified": false}})");
  writeText("frames.csv",
            "frame,time_s,left,right\n"
            "0,0,left/00.png,right/00.png\n1,1,left/01.png,right/01.png\n");
  writeText("odometry.tum", "0 0 0 0 0 0 0 1\n1 2 0 0 0 0 0 1\n");
  expectDone(run({"validate", "."}), "ok: .: recording of 2 frames\n");
}

TEST_F(Calibrate, RefusesWhatCannotBe) {
  expectFailed(run(calibrateWith({})), 1,
               "handmap-cli: error: --board is required\nhint: handmap-cli calibrate --help\n");
  for (const std::string board : {"9", "9x9", "9x600", "9x6x3"}) {
    expectFailed(run(calibrateWith({"--board", board})), 1,
                 "handmap-cli: error: --board: found " + board +
                     ", expected two different numbers of inner corners from 3 to 50, as 9x6\n");
  }
  expectFailed(run(calibrateWith({"--board", "9x6"})), 2,
               "handmap-cli: error: left: found no such folder, expected a folder of images\n");
  for (const std::string side : {"left", "right"}) {
    fs::create_directory(side);
    fs::copy(fs::path(HANDMAP_TEST_DATA) / "tiles-160x96.png", side + "/0.png");
  }
  expectFailed(run(calibrateWith({"--board", "9x6"})), 2,
               "handmap-cli: error: left and right: found 0 pairs that show the whole board, "
               "expected at least 6; the first refused, 0: no whole board of 9 × 6 corners in the "
               "left image\n"
               "hint: take 15 to 30 pairs, the board near and far, tilted and turned, in all "
               "corners; is the number of inner corners right?\n");
  EXPECT_FALSE(fs::exists("calib.yml"));
}

}  // namespace
}  // namespace handmap
