#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

/// Three times the same pair, a second apart.
class Odometry : public CliTest {
 protected:
  Odometry() {
    fs::create_directories("rec/image_0");
    fs::create_directories("rec/image_1");
    writeText("rec/recording.json", R"({"format": "handmap-recording", "version": 1})");
    writeText("rec/calib.txt",
              "P0: 100 0 80 0 0 100 48 0 0 0 1 0\nP1: 100 0 80 -50 0 100 48 0 0 0 1 0\n");
    writeText("rec/frames.csv", "frame,time_s,left,right\n" + row(0) + row(1) + row(2));
    for (const std::string frame : {"0", "1", "2"}) {
      copyImage("tiles-160x96.png", "image_0/" + frame);
      copyImage("tiles-right-160x96.png", "image_1/" + frame);
    }
  }

  static std::string row(int frame) {
    const std::string number = std::to_string(frame);
    return number + "," + number + ",image_0/" + number + ".png,image_1/" + number + ".png\n";
  }
  static void copyImage(const std::string& name, const std::string& to) {
    fs::copy_file(fs::path(HANDMAP_TEST_DATA) / name, "rec/" + to + ".png",
                  fs::copy_options::overwrite_existing);
  }
};

const std::vector<std::string> kOdometry{"odometry", "--recording", "rec", "--out", "out.tum"};

TEST_F(Odometry, OfARobotAtRest) {
  expectDone(run(kOdometry), "out.tum: 3 poses over 0.00 m, 0 guessed, 0 frames skipped\n");
  expectDone(run({"validate", "out.tum"}), "ok: out.tum: trajectory of 3 poses\n");
  const std::string first = contentOf("out.tum");
  run(kOdometry);
  EXPECT_EQ(contentOf("out.tum"), first);
}

TEST_F(Odometry, NeedsReturnsToMatchScans) {
  expectFailed(run({"odometry", "--recording", "rec", "--odometry", "scan", "--out", "out.tum"}), 2,
               "handmap-cli: error: rec: found no frame with points from 0 to the end, expected "
               "at least one\n");
}

TEST_F(Odometry, AutoTellsWhatItTook) {
  const Outcome outcome =
      run({"odometry", "--recording", "rec", "--odometry", "auto", "--out", "out.tum"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err.find("odometry: visual taken: nothing recorded\n"), 0U) << outcome.err;
}

TEST_F(Odometry, IsTakenByARunOnRequestAndWhereThereIsNoOther) {
  const std::vector<std::string> arguments{"run", "--map", "row-drawn.handmap", "--recording",
                                           "rec", "--out", "a.handmap"};
  const Outcome without = run(arguments);
  EXPECT_EQ(without.status, 0) << without.err;
  EXPECT_EQ(without.out.find("3 observations used, 0 skipped\n"), 0U) << without.out;
  writeText("rec/odometry.tum", "0 0 0 0 0 0 0 1\n2 90 0 0 0 0 0 1\n");
  std::vector<std::string> visual = arguments;
  visual.back() = "b.handmap";
  visual.insert(visual.end(), {"--odometry", "visual"});
  EXPECT_EQ(run(visual).status, 0);
  EXPECT_EQ(contentOf("a.handmap"), contentOf("b.handmap"));
  const auto map = nlohmann::json::parse(contentOf("a.handmap"));
  EXPECT_EQ(map["refinement"]["odometry"], "visual");
  expectFailed(run({"run", "--map", "row-drawn.handmap", "--recording", "rec", "--source", "points",
                    "--odometry", "visual"}),
               2,
               "handmap-cli: error: rec: found no frame with points from 0 to the end, expected "
               "at least one\n");
}

TEST_F(Odometry, GuessesAndSaysSo) {
  for (const std::string camera : {"image_0/1", "image_1/1"}) {
    copyImage("tiles-160x96.png", camera);  // no disparity: too far away to tell a motion
  }
  const Outcome outcome = run(kOdometry);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "out.tum: 3 poses over 0.00 m, 1 guessed, 0 frames skipped\n");
  EXPECT_EQ(outcome.err, "handmap-cli: frame 1: motion guessed\n");
  const Outcome localized =
      run({"run", "--map", "row-drawn.handmap", "--recording", "rec", "--report", "report.json"});
  EXPECT_EQ(localized.err.find("handmap-cli: frame 1: motion guessed\n"
                               "handmap-cli: warning: No building was recognised in 3 "
                               "observations: "),
            0U)
      << localized.err;
  const auto report = nlohmann::json::parse(contentOf("report.json"));
  EXPECT_EQ(report["frames"][1]["odometry_guessed"], true);
  EXPECT_FALSE(report["frames"][2].contains("odometry_guessed"));
  expectDone(run({"validate", "rec"}), "ok: rec: recording of 3 frames\n");
}

TEST_F(Odometry, EndsWhereNothingTellsTheMotion) {
  copyImage("tiles-160x96.png", "image_1/1");
  writeText("rec/frames.csv",
            "frame,time_s,stop,left,right\n"
            "0,0,0,image_0/0.png,image_1/0.png\n"
            "1,1,1,image_0/1.png,image_1/1.png\n");
  expectFailed(run(kOdometry), 3,
               "handmap-cli: error: frame 1: found 0 points in common with frame 0, 0 of them "
               "moving as one: too few to tell how the robot moved in between\n"
               "hint: take more frames (a smaller --every), or give an odometry: --odometry "
               "FILE.tum\n");
  EXPECT_FALSE(fs::exists("out.tum"));
}

TEST_F(Odometry, RefusesSwappedImages) {
  for (const std::string frame : {"0", "1", "2"}) {
    copyImage("tiles-160x96.png", "image_1/" + frame);
    copyImage("tiles-right-160x96.png", "image_0/" + frame);
  }
  const Outcome outcome = run(kOdometry);
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("handmap-cli: error: none of 3 observations could be used; the first: "
                             "rec/image_1/0.png: found "),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("left and right look swapped\n"), std::string::npos);
  EXPECT_FALSE(fs::exists("out.tum"));
}

TEST_F(Odometry, NeedsImages) {
  expectFailed(run({"odometry", "--recording", "rec"}), 1,
               "handmap-cli: error: --out is required\nhint: handmap-cli odometry --help\n");
  writeText("rec/frames.csv", "frame,time_s,points\n0,0,points/0.bin\n");
  expectFailed(run(kOdometry), 2,
               "handmap-cli: error: rec: found no frame with images from 0 to the end, expected at "
               "least one\n");
}

}  // namespace
}  // namespace handmap
