#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "tests/cli/program.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;
using Validate = CliTest;

TEST_F(Validate, NotesLikelySlipsOfADrawingThatIsWhole) {
  std::ofstream("yard.handmap") << R"({"format": "handmap", "version": 1, "buildings": [
      {"id": "A", "shape": "rectangle", "x": 0, "y": 0, "width": 10, "depth": 8, "heading_deg": 0},
      {"id": "B", "shape": "rectangle", "x": 7, "y": 0, "width": 10, "depth": 8, "heading_deg": 0}]})";
  const Outcome outcome = run({"validate", "yard.handmap"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "ok: yard.handmap: map of 2 buildings\n");
  EXPECT_EQ(outcome.err,
            "handmap-cli: note: yard.handmap: there is no start: a run needs to know where the "
            "robot begins\n"
            "handmap-cli: note: yard.handmap: A and B overlap by 24.0 m²\n");
}

TEST_F(Validate, WarnsOfWhatMayBeRightAndRefusesWhatCannotBe) {
  ASSERT_EQ(run({"simulate", "--laser", "--out", "rec"}).status, 0);
  EXPECT_EQ(run({"validate", "rec"}).err, "");
  replaceIn("rec/recording.json", "range_limit_m", "range_limit");
  const Outcome warned = run({"validate", "rec"});
  EXPECT_EQ(warned.status, 0);
  EXPECT_EQ(warned.err.find("handmap-cli: warning: rec/recording.json: range_limit: found a key "
                            "that nothing knows, expected range_limit_m\nhint: "),
            0U)
      << warned.err;
  std::string far = "1 0 0 0 0 0 0 1\n";
  for (int i = 2; i < 1000; ++i) far += fmt::format("{} {} 0 0 0 0 0 1\n", i, 1000 * i);
  writeText("rec/odometry.tum", far);
  const Outcome refused = run({"run", "--map", "rec/sketch.handmap", "--recording", "rec"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("error: rec/odometry.tum: line 2: found a robot that drives 1000 m/s"),
            std::string::npos)
      << refused.err;
  fs::rename("rec/odometry.tum", "mine.tum");
  const Outcome given =
      run({"run", "--map", "rec/sketch.handmap", "--recording", "rec", "--odometry", "mine.tum"});
  EXPECT_EQ(given.status, 2);
  EXPECT_NE(given.err.find("error: mine.tum: line 2: found a robot that drives 1000 m/s"),
            std::string::npos)
      << given.err;
}

TEST_F(Validate, RefusesADrawingInMillimetres) {
  writeText("yard.handmap", R"({"format": "handmap", "version": 1, "buildings": [
      {"id": "A", "shape": "rectangle", "x": 0, "y": 0, "width": 40000, "depth": 8000,
       "heading_deg": 0}]})");
  const Outcome outcome = run({"validate", "yard.handmap"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err,
            "handmap-cli: error: yard.handmap: buildings[0]: found half of them longer than 40000 "
            "m, expected metres\nhint: these look like millimetres\n");
}

TEST_F(Validate, SaysTheSameThreeTimesAndThenCounts) {
  ASSERT_EQ(run({"simulate", "--laser", "--out", "rec"}).status, 0);
  fs::remove("rec/points/minute-0000.bin");
  const std::string err = run({"validate", "rec"}).err;
  std::size_t said = 0;
  for (std::size_t at = err.find("no such file"); at != std::string::npos;
       at = err.find("no such file", at + 1)) {
    ++said;
  }
  EXPECT_EQ(said, 4U) << err;  // and once with the count
  EXPECT_NE(err.find(" more like: frame 0: rec/points/minute-0000.bin"), std::string::npos);
}

TEST_F(Validate, OfARobot) {
  const fs::path rigs = fs::path(HANDMAP_SOURCES) / "resources/rigs";
  fs::copy(rigs / "laser-cart.json", "rig.json");
  expectDone(run({"validate", "rig.json"}), "ok: rig.json: rig of a scanner\n");
  const Outcome tried = run({"try", "rig.json", "--for", "1"});
  EXPECT_EQ(tried.status, 3);
  EXPECT_NE(tried.out.find("scanner   lost       no data in 1 s: /dev/ttyACM0 is not there"),
            std::string::npos)
      << tried.out;
}

TEST_F(Validate, OfWhatTheGuidesScriptWrites) {
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no python3";
  const std::string script = HANDMAP_SOURCES "/resources/guide/write_recording.py";
  ASSERT_EQ(std::system(("python3 " + script + " rec").c_str()), 0);
  expectDone(run({"validate", "rec"}), "ok: rec: recording of 40 frames\n");
}

TEST_F(Validate, OfAnImportedLog) {
  std::string log;
  for (int i = 0; i < 20; ++i) {
    log += "FLASER 180";
    for (int r = 0; r < 180; ++r) log += r % 2 == 0 ? " 5.5" : " 81.83";
    log += fmt::format(" 0 0 0 {} 0 0 {} host 0\n", 0.1 * i, 100 + 0.1 * i);
  }
  writeText("laser.log", log);
  const Outcome imported = run({"import", "laser.log", "--out", "rec", "--quiet"});
  expectDone(imported, "rec: recording of 20 scans and 20 poses\n");
  EXPECT_EQ(run({"validate", "rec"}).status, 0);
  writeText("odd.csv", "1,2,3\n4,5,6\n");
  expectFailed(run({"import", "odd.csv", "--out", "other"}), 2,
               "handmap-cli: error: odd.csv: found the columns 1 2 3, expected to know which hold "
               "what\nhint: --columns: ROLE=COLUMN,… as time=1,ranges=2-362 or time=t,x=px,y=py\n");
}

}  // namespace
}  // namespace handmap
