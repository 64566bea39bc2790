// No output takes the place of what is read, nor of a recording's files.
#include <algorithm>

#include "tests/cli/program.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

class Outputs : public CliTest {
 protected:
  Outputs() {
    EXPECT_EQ(run({"simulate", "--seed", "3", "--out", "R"}).status, 0);
    for (const auto& entry : fs::recursive_directory_iterator("R"))
      if (entry.is_regular_file()) before_.emplace_back(entry.path(), contentOf(entry.path()));
    fs::create_directory_symlink("R", "link");
    fs::create_symlink(fs::absolute("R/frames.csv"), "table.csv");
  }
  ~Outputs() override {
    for (const auto& [path, content] : before_) EXPECT_EQ(contentOf(path), content) << path;
  }
  static Outcome runWith(const std::vector<std::string>& outputs) {
    std::vector<std::string> arguments{"run",  "--map", "R/sketch.handmap", "--recording", "R",
                                       "--to", "2"};
    arguments.insert(arguments.end(), outputs.begin(), outputs.end());
    return run(arguments);
  }

 private:
  std::vector<std::pair<fs::path, std::string>> before_;
};

TEST_F(Outputs, AreRefusedOverTheFilesOfARecording) {
  for (const auto& [option, file] : {std::pair("--trajectory", "R/odometry.tum"),
                                     {"--out", "R/frames.csv"},
                                     {"--report", "R/recording.json"},
                                     {"--local-map", "R/points/minute-0000.bin"},
                                     {"--trajectory", "R/truth.tum"},
                                     {"--trajectory", "link/odometry.tum"},
                                     {"--out", "table.csv"},
                                     {"--trajectory", "R/../R/ODOMETRY.TUM"},
                                     {"--report", "R/acts.jsonl"}}) {
    const Outcome outcome = runWith({option, file});
    EXPECT_EQ(outcome.status, 2) << file;
    EXPECT_NE(outcome.err.find(std::string(file) + ": found a file of the recording"),
              std::string::npos)
        << outcome.err;
  }
}

TEST_F(Outputs, AreRefusedOverInputs) {
  for (const char* file : {"R/sketch.handmap", "link/sketch.handmap"}) {
    const Outcome outcome = runWith({"--out", file});
    EXPECT_EQ(outcome.status, 1) << file;
    EXPECT_NE(outcome.err.find("it is an input"), std::string::npos) << outcome.err;
  }
  fs::create_hard_link("R/sketch.handmap", "hard.handmap");
  EXPECT_EQ(runWith({"--report", "hard.handmap"}).status, 1);
  fs::create_directories("images");
  writeText("images/0.png", "not read");
  const Outcome training = run({"train", "--images", "images", "--labels", "images", "--label", "1",
                                "--out", "images/0.png"});
  EXPECT_EQ(training.status, 1);
  EXPECT_EQ(contentOf("images/0.png"), "not read");
}

TEST_F(Outputs, MayLieBesideARecordingsFilesAndReplaceEarlierOnes) {
  for (int round = 0; round < 2; ++round) {
    const Outcome outcome = runWith({"--out", "R/refined.handmap", "--trajectory", "R/way.tum"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
  fs::remove("R/refined.handmap");
  fs::remove("R/way.tum");
}

TEST_F(Outputs, AnOdometryMayBeGivenToARecordingThatHasNone) {
  EXPECT_EQ(
      run({"odometry", "--recording", "R", "--odometry", "scan", "--out", "R/odometry.tum"}).status,
      2);
}

}  // namespace
}  // namespace handmap
