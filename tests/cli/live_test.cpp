// A live robot on the command line: the virtual rig.
#include <csignal>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

class Live : public CliTest {
 protected:
  Live() { EXPECT_EQ(run({"simulate", "--seed", "3", "--out", "sim"}).status, 0); }

  static std::vector<std::string> live(std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "--map", "sim/sketch.handmap", "--virtual-rig",
                               "--slam-particles", "20", "--threads", "1"});
    return more;
  }
  static std::size_t linesOf(const fs::path& path) {
    const std::string text = contentOf(path);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  /// Until the recording has so many rows, or half a minute has passed.
  static bool waitForRows(const fs::path& table, std::size_t rows) {
    for (int i = 0; i < 600 && linesOf(table) <= rows; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return linesOf(table) > rows;
  }
};

TEST_F(Live, WhatWasRecordedReplaysToTheSameBytes) {
  const Outcome lived = run(
      live({"--for", "6", "--record", "rec", "--out", "live.handmap", "--trajectory", "live.tum"}));
  ASSERT_EQ(lived.status, 0) << lived.err;
  EXPECT_NE(lived.err.find("handmap-cli: scanner: ready\n"), std::string::npos) << lived.err;
  EXPECT_NE(lived.err.find("observations in rec\n"), std::string::npos) << lived.err;
  EXPECT_GT(linesOf("live.tum"), 5U);
  const Outcome again =
      run({"run", "--map", "sim/sketch.handmap", "--recording", "rec", "--slam-particles", "20",
           "--out", "again.handmap", "--trajectory", "again.tum"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(contentOf("live.tum"), contentOf("again.tum"));
  EXPECT_EQ(contentOf("live.handmap"), contentOf("again.handmap"));
  EXPECT_EQ(lived.out, again.out);
}

TEST_F(Live, AfterKill9TheRecordingIsWholeUpToTheLastFrame) {
  const pid_t program = start(live({"--record", "rec"}));
  EXPECT_TRUE(waitForRows("rec/frames.csv", 4));
  EXPECT_EQ(kill(program, SIGKILL), 0);
  EXPECT_EQ(finish(program).status, -1);
  const Outcome checked = run({"validate", "rec"});
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_EQ(std::distance(fs::directory_iterator("rec/points"), {}), 1);
}

TEST_F(Live, CtrlCEndsTheDriveAndWritesWhatWasFound) {
  const pid_t program = start(live({"--record", "rec", "--out", "live.handmap"}));
  EXPECT_TRUE(waitForRows("rec/frames.csv", 4));
  EXPECT_EQ(kill(program, SIGINT), 0);
  const Outcome outcome = finish(program);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("observations used"), std::string::npos);
  EXPECT_TRUE(fs::exists("live.handmap"));
}

TEST_F(Live, ARecordingCanBeReadWhateverEndsTheProgram) {
  for (const std::size_t rows : {1U, 5U, 9U}) {
    const std::string folder = "rec" + std::to_string(rows);
    const pid_t program = start(live({"--record", folder, "--out", "live.handmap"}));
    EXPECT_TRUE(waitForRows(folder + "/frames.csv", rows));
    EXPECT_EQ(kill(program, SIGKILL), 0);
    EXPECT_EQ(finish(program).status, -1);
    EXPECT_FALSE(fs::exists("live.handmap"));
    const Outcome checked = run({"validate", folder});
    EXPECT_EQ(checked.status, 0) << checked.err;
    const Outcome replayed = run({"run", "--map", "sim/sketch.handmap", "--recording", folder,
                                  "--slam-particles", "20", "--to", "8"});
    EXPECT_EQ(replayed.status, 0) << replayed.err;
  }
}

TEST_F(Live, FaultsAreNamedAndTheRunGoesOn) {
  const Outcome outcome =
      run(live({"--for", "6", "--faults", "scanner:unplug@2+1.5,odometry:clock@4+0.5", "--out",
                "live.handmap"}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("handmap-cli: scanner: lost: unplugged\n"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("times: odometry stamped in the future\n"), std::string::npos)
      << outcome.err;
  EXPECT_TRUE(fs::exists("live.handmap"));
}

TEST_F(CliTest, ALiveRunSaysWhatItCannotDo) {
  const std::vector<std::string> base{"run", "--map", "row-drawn.handmap"};
  const auto with = [&base](std::vector<std::string> more) {
    more.insert(more.begin(), base.begin(), base.end());
    return run(more);
  };
  const auto complaint = [](const std::string& words) {
    return "handmap-cli: error: " + words + "\n";
  };
  expectFailed(with({}), 1,
               complaint("found none of --recording, --rig and --virtual-rig, expected one"));
  expectFailed(with({"--virtual-rig", "--rig", "a.json"}), 1,
               complaint("found 2 of --recording, --rig and --virtual-rig, expected one"));
  expectFailed(with({"--virtual-rig", "--speed", "1"}), 1,
               complaint("--speed: only with --recording"));
  expectFailed(with({"--recording", "rec", "--for", "3"}), 1,
               complaint("--for: only with --rig or --virtual-rig"));
  expectFailed(with({"--rig", "none.json", "--for", "3"}), 2,
               complaint("none.json: found no such file, expected a readable file"));
  const Outcome fault = with({"--virtual-rig", "--faults", "scanner:melt@1+1"});
  EXPECT_EQ(fault.status, 1);
  EXPECT_NE(fault.err.find("scanner:melt@1+1"), std::string::npos);
  writeText("rig.json", R"({"format": "handmap-rig", "version": 1, "camera":
      {"device": "/dev/none", "calibration": "calib.yml"}})");
  const Outcome calibration = with({"--rig", "rig.json", "--for", "3"});
  EXPECT_EQ(calibration.status, 2);
  EXPECT_NE(calibration.err.find("calib.yml"), std::string::npos) << calibration.err;
}

TEST_F(CliTest, ALiveRunThatSeesNothingSaysWhy) {
  writeText("rig.json", R"({"format": "handmap-rig", "version": 1,
      "scanner": {"kind": "hokuyo", "port": "127.0.0.1"},
      "odometry": {"kind": "lines", "port": "/dev/none"}})");
  const Outcome outcome =
      run({"run", "--map", "row-drawn.handmap", "--rig", "rig.json", "--for", "9"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("nothing to be seen yet; odometry: no data, "), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("; scanner: no data, "), std::string::npos) << outcome.err;
}

TEST_F(CliTest, EachDeviceOfARobotIsTried) {
  writeText("rig.json", R"({"format": "handmap-rig", "version": 1,
      "scanner": {"kind": "hokuyo", "port": "127.0.0.1"},
      "odometry": {"kind": "lines", "port": "/dev/none"}})");
  const Outcome tried = run({"try", "rig.json", "--for", "2"});
  EXPECT_EQ(tried.status, 3) << tried.err;
  EXPECT_NE(tried.out.find(
                "scanner   lost       no data in 2 s: tcp://127.0.0.1:10940: Connection refused"),
            std::string::npos)
      << tried.out;
  EXPECT_NE(tried.out.find("no data in 2 s: /dev/none is not there: is it plugged in?"),
            std::string::npos)
      << tried.out;
}

}  // namespace
}  // namespace handmap
