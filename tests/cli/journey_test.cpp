// From a world to its corrected map.
#include <csignal>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "core/map/map_io.h"
#include "tests/cli/program.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

class Journey : public CliTest {
 protected:
  /// Sets out in the two-row world of seed 1.
  Journey() {
    expectDone(run({"simulate", "--seed", "1", "--sigma", "3", "--out", "rec"}),
               "rec: 40 observations, truth.handmap and sketch.handmap of 6 buildings\n");
  }

  static std::vector<std::string> slam(std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "--map", "rec/sketch.handmap", "--recording", "rec",
                               "--slam-particles", "20", "--pso-particles", "10"});
    return more;
  }

  static double meanError(const std::string& map, const char* measure) {
    const Outcome outcome = run({"compare", map, "rec/truth.handmap", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out)["as_it_is"]["mean"][measure];
  }
};

TEST_F(Journey, CorrectsTheSketch) {
  expectDone(run({"validate", "rec", "rec/truth.handmap", "rec/sketch.handmap", "rec/truth.tum"}),
             "ok: rec: recording of 40 frames\n"
             "ok: rec/truth.handmap: map of 6 buildings\n"
             "ok: rec/sketch.handmap: map of 6 buildings\n"
             "ok: rec/truth.tum: trajectory of 40 poses\n");
  const Outcome outcome = run(
      slam({"--out", "refined.handmap", "--trajectory", "refined.tum", "--report", "report.json"}));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(complaints(outcome.err), "");
  EXPECT_EQ(outcome.out.find("40 observations used, 0 skipped\nrobot at "), 0U) << outcome.out;
  EXPECT_LT(meanError("refined.handmap", "front"), meanError("rec/sketch.handmap", "front"));
  EXPECT_LT(meanError("refined.handmap", "x"), meanError("rec/sketch.handmap", "x"));

  const auto report = nlohmann::json::parse(contentOf("report.json"));
  EXPECT_EQ(report["frames"].size(), 40U);
  EXPECT_TRUE(report["skipped"].empty());
  const auto refined = nlohmann::json::parse(contentOf("refined.handmap"));
  EXPECT_EQ(refined["refinement"]["seed"], 1);
  EXPECT_TRUE(refined["buildings"][0].contains("estimate"));

  const Outcome compared = run({"compare", "refined.handmap", "rec/truth.handmap", "--trajectory",
                                "refined.tum", "--truth", "rec/truth.tum", "--json"});
  const auto error = nlohmann::json::parse(compared.out)["trajectory"];
  EXPECT_EQ(error["poses"], 40);
  EXPECT_NEAR(error["length_m"].get<double>(), 195.0, 0.1);
  EXPECT_LT(error["rms_m"].get<double>(), 0.73);  // the odometry: 1.2
}

TEST_F(Journey, KeepsARunInOneFolderAndMakesAPageOfIt) {
  EXPECT_EQ(run(slam({"--to", "6", "--keep", "kept"})).status, 0);
  for (const char* name :
       {"drawing.handmap", "refined.handmap", "trajectory.tum", "report.json", "run.mcap"}) {
    EXPECT_TRUE(fs::exists(fs::path("kept") / name)) << name;
  }
  expectDone(run({"report", "--run", "kept", "--truth", "rec/truth.handmap", "--out", "run.html"}),
             "");
  EXPECT_NE(contentOf("run.html").find("trajectory"), std::string::npos);
  expectDone(run({"report", "--run", "kept", "--out", "walls.csv"}), "");
  EXPECT_NE(contentOf("walls.csv").find("\nbuilding,"), std::string::npos);
  expectDone(run({"report", "--run", "kept", "--out", "copy.mcap"}), "");
  EXPECT_EQ(contentOf("copy.mcap"), contentOf("kept/run.mcap"));
  EXPECT_FALSE(fs::exists("copy.mcap.part"));
  expectFailed(run({"report", "--run", "rec", "--out", "copy.mcap"}), 2,
               "handmap-cli: error: rec/run.mcap: found no such file, expected a readable file\n");
  expectFailed(
      run({"report", "--run", "rec", "--out", "run.html"}), 2,
      "handmap-cli: error: rec/drawing.handmap: found no such file, expected a readable file\n");
  EXPECT_EQ(run({"report", "--run", "kept", "--out", "kept/refined.handmap"}).status, 1);
}

TEST_F(Journey, LeavesNoEmptyFolderOfARunThatDidNotBegin) {
  EXPECT_EQ(
      run({"run", "--map", "none.handmap", "--recording", "rec", "--keep", "not-kept"}).status, 2);
  EXPECT_FALSE(fs::exists("not-kept"));
}

TEST_F(Journey, IsTheSameOnOneThreadAndOnTwo) {
  std::vector<std::string> bytes;
  for (const std::string threads : {"1", "2", "2"}) {
    const Outcome outcome = run(slam(
        {"--every", "2", "--threads", threads, "--out", "m.handmap", "--trajectory", "t.tum"}));
    EXPECT_EQ(outcome.status, 0);
    bytes.push_back(outcome.out + contentOf("m.handmap") + contentOf("t.tum"));
  }
  EXPECT_GT(bytes[0].size(), 2000U);
  EXPECT_EQ(bytes[0], bytes[1]);
  EXPECT_EQ(bytes[1], bytes[2]);
}

TEST_F(Journey, AnotherSeedIsAnotherDrawOfTheParticles) {
  const auto buildings = [](const std::string& seed) {
    EXPECT_EQ(run(slam({"--method", "paper", "--every", "8", "--seed", seed, "--out", "m.handmap"}))
                  .status,
              0);
    return nlohmann::json::parse(contentOf("m.handmap"))["buildings"];
  };
  const auto one = buildings("1");
  EXPECT_NE(one, buildings("2"));
  EXPECT_EQ(one, buildings("1"));
}

TEST_F(Journey, LocalizesWithoutTouchingTheDrawing) {
  EXPECT_EQ(run(slam({"--localize-only", "--to", "10", "--out", "same.handmap"})).status, 0);
  const auto drawn = nlohmann::json::parse(contentOf("rec/sketch.handmap"));
  const auto same = nlohmann::json::parse(contentOf("same.handmap"));
  for (std::size_t i = 0; i < 6; ++i) {
    for (const char* key : {"x", "y", "width", "depth"}) {
      EXPECT_EQ(drawn["buildings"][i][key], same["buildings"][i][key]);
    }
  }
}

TEST_F(Journey, TakesAPoseThatIsGiven) {
  writeText("lost.tum", "4 30 -4 0 0 0 0 1\n");  // by the first building of the other row
  ASSERT_EQ(run(slam({"--method", "paper", "--localize-only", "--to", "6", "--given-poses",
                      "lost.tum", "--out", "given.handmap", "--report", "report.json"}))
                .status,
            0);
  const auto report = nlohmann::json::parse(contentOf("report.json"));
  EXPECT_EQ(report["settings"]["given_poses"], nlohmann::json::parse("[[4.0, 30.0, -4.0, 0.0]]"));
  // The map says enough to make it again.
  EXPECT_EQ(nlohmann::json::parse(contentOf("given.handmap"))["refinement"]["given_poses"],
            report["settings"]["given_poses"]);
  writeText("late.tum", "40000 30 -4 0 0 0 0 1\n");
  expectFailed(run(slam({"--given-poses", "late.tum"})), 2,
               "handmap-cli: error: a pose is given at 40000 s, but the odometry of the run does "
               "not reach there\nhint: give times of the recording\n");
}

TEST_F(Journey, AGivenPoseTakesNoPictureFromTheRun) {
  ASSERT_EQ(run({"simulate", "--images", "--moving", "--step", "12", "--width", "96", "--height",
                 "64", "--out", "seen"})
                .status,
            0);
  std::istringstream truth(contentOf("seen/truth.tum"));
  std::vector<std::string> poses;
  for (std::string line; std::getline(truth, line);) {
    if (!line.starts_with("#")) poses.push_back(line);
  }
  ASSERT_GT(poses.size(), 4U);
  writeText("given.tum", poses[poses.size() / 2] + "\n");
  ASSERT_EQ(run({"run", "--map", "seen/sketch.handmap", "--recording", "seen", "--given-poses",
                 "given.tum", "--mcap", "seen.mcap"})
                .status,
            0);
  const std::string held = run({"info", "seen.mcap"}).out;
  std::smatch count;
  ASSERT_TRUE(std::regex_search(held, count, std::regex(R"(image/compressed\s+\S+\s+(\d+))")));
  EXPECT_EQ(std::stoul(count[1]), poses.size());
}

TEST_F(Journey, SimulatesHardPlacesTheSameEveryTime) {
  const std::vector<std::vector<std::string>> places{
      {"--scene", "terraces", "--laser", "--step", "5", "--sheds", "--wrong", "2", "--start-off",
       "2,5", "--drift", "5,0.03", "--rounds", "2"},
      {"--scene", "street", "--features", "27", "--joined", "40", "--step", "5", "--rough"},
      {"--scene", "two-rows", "--images", "--moving", "--step", "40", "--sheds", "--rounds", "2",
       "--width", "64", "--height", "64"}};
  for (const std::vector<std::string>& place : places) {
    for (const char* out : {"hard", "again"}) {
      std::filesystem::remove_all(out);
      std::vector<std::string> arguments{"simulate", "--seed", "2", "--out", out};
      arguments.insert(arguments.end(), place.begin(), place.end());
      ASSERT_EQ(run(arguments).status, 0);
    }
    const Outcome valid = run({"validate", "hard", "hard/truth.handmap", "hard/sketch.handmap"});
    EXPECT_EQ(valid.status, 0) << valid.err;
    for (const auto& entry : std::filesystem::recursive_directory_iterator("hard")) {
      if (!entry.is_regular_file()) continue;
      const auto twin = "again" / std::filesystem::relative(entry.path(), "hard");
      EXPECT_EQ(contentOf(entry.path()), contentOf(twin)) << twin;
    }
  }
  ASSERT_TRUE(std::filesystem::exists("hard/truth.handmap"));
  EXPECT_EQ(readMap("hard/truth.handmap").buildings.size(), 6U);  // sheds are not in it
  expectFailed(run({"simulate", "--wrong", "6", "--out", "gone"}), 2,
               "handmap-cli: error: buildings to leave out: found 6, expected more than 6\n");
}

TEST_F(Journey, SimulatesAMapOfOnesOwn) {
  expectDone(run({"simulate", "--world", "row-truth.handmap", "--out", "row"}),
             "row: 17 observations, truth.handmap and sketch.handmap of 3 buildings\n");
  expectDone(run({"simulate", "--scene", "campus", "--seed", "4", "--out", "campus"}),
             "campus: 54 observations, truth.handmap and sketch.handmap of 15 buildings\n");
  expectDone(run({"simulate", "--scene", "loop", "--view", "180", "--out", "loop"}),
             "loop: 218 observations, truth.handmap and sketch.handmap of 39 buildings\n");
  EXPECT_EQ(
      run({"validate", "row", "campus", "row/sketch.handmap", "campus/sketch.handmap", "loop"}).err,
      "");
  writeText("blocked.handmap",
            R"({"format": "handmap", "version": 1, "route": [[0, 0], [80, 0]], "buildings": [
                {"id": "A", "shape": "rectangle", "x": 50, "y": 0, "width": 20, "depth": 10,
                 "heading_deg": 0}]})");
  expectFailed(run({"simulate", "--world", "blocked.handmap", "--out", "blocked"}), 2,
               "handmap-cli: error: blocked.handmap: route: found building A in the way after 40 "
               "m, expected a way "
               "around the buildings\n");
  EXPECT_FALSE(fs::exists("blocked"));
}

std::string partOfFrame3() {
  const std::string table = contentOf("rec/frames.csv");
  std::smatch found;
  std::regex_search(table, found, std::regex(R"(\n3,[^\n]*(points/[^\n]*))"));
  return "rec/" + found[1].str();
}

TEST_F(Journey, SkipsAFrameThatCannotBeRead) {
  const std::string table = contentOf("rec/frames.csv");
  writeText("rec/frames.csv",
            std::regex_replace(table, std::regex(R"((\n3,[^\n]*\+)\d+)"), "$017"));
  const Outcome outcome = run(slam({"--to", "6", "--report", "report.json"}));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(complaints(outcome.err),
            "handmap-cli: frame 3 skipped: " + partOfFrame3() +
                ": found 7 bytes, expected 16 bytes a point (x y z w) or 12 (x y z)\n");
  EXPECT_EQ(outcome.out.find("6 observations used, 1 skipped\n"), 0U) << outcome.out;
  EXPECT_EQ(nlohmann::json::parse(contentOf("report.json"))["skipped"][0]["frame"], 3);
  const Outcome checked = run({"validate", "rec"});
  EXPECT_EQ(checked.status, 2);
  EXPECT_EQ(checked.out, "");
}

TEST_F(Journey, ALaserWithoutOdometryRuns) {
  ASSERT_EQ(run({"simulate", "--laser", "--out", "laser"}).status, 0);
  fs::remove("laser/odometry.tum");
  const Outcome outcome =
      run({"run", "--map", "laser/sketch.handmap", "--recording", "laser", "--to", "20", "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find("odometry: none is recorded, the scans tell the motion\n"), 0U);
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["observations"], 21);
  EXPECT_EQ(result["buildings"].size(), 6U);
}

TEST_F(Journey, TellsItsResultToPrograms) {
  const Outcome outcome = run(slam({"--json", "--quiet"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["observations"], 40);
  EXPECT_EQ(result["skipped"], 0);
  EXPECT_TRUE(result["pose"]["heading_deg"].is_number());
  ASSERT_EQ(result["buildings"].size(), 6U);
  EXPECT_TRUE(result["buildings"][0]["sigma_x"].is_number() ||
              result["buildings"][0]["estimate"]["sigma_x"].is_number())
      << outcome.out;
  EXPECT_TRUE(result["warnings"].is_array());
}

TEST_F(Journey, QuietItSaysNothing) {
  const Outcome outcome = run(slam({"--to", "6", "--quiet"}));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Journey, FailsWithoutAReadableFrame) {
  for (const auto& entry : fs::directory_iterator("rec/points")) writeText(entry.path(), "");
  const Outcome outcome = run(slam({"--to", "1", "--out", "refined.handmap"}));
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_FALSE(fs::exists("refined.handmap"));
}

TEST_F(Journey, StopsWhenInterruptedAndWritesNothing) {
  const pid_t program =
      start({"run", "--map", "rec/sketch.handmap", "--recording", "rec", "--method", "paper",
             "--slam-particles", "20000", "--out", "refined.handmap"});
  for (int i = 0; i < 600 && contentOf("stderr").empty(); ++i) {  // until it tells its progress
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_EQ(kill(program, SIGINT), 0);
  const Outcome outcome = finish(program);
  EXPECT_EQ(outcome.status, 130);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(complaints(outcome.err), "handmap-cli: interrupted, nothing written\n");
  EXPECT_FALSE(fs::exists("refined.handmap"));
}

TEST_F(Journey, ABarOnATerminalEndsWithTheRun) {
  if (std::system("script --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no script";
  const std::string command =
      HANDMAP_CLI " run --map rec/sketch.handmap --recording rec --out o.handmap";
  ASSERT_EQ(std::system(("script -qec '" + command + "' tty > /dev/null 2>&1").c_str()), 0);
  const std::string shown = contentOf("tty");
  double most = 0.0;
  for (std::size_t at = shown.find("] "); at != std::string::npos; at = shown.find("] ", at + 1)) {
    most = std::max(most, std::atof(shown.c_str() + at + 2));
  }
  EXPECT_GT(most, 0.0) << shown;
  EXPECT_LE(most, 100.0) << shown;
}

}  // namespace
}  // namespace handmap
