#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include "core/bags/mcap_writer.h"
#include "core/recording/frame_table.h"
#include "tests/cli/program.h"

namespace handmap {
namespace {

using BagsCli = CliTest;

void writeDrive(const std::filesystem::path& path, bool scans) {
  McapWriter writer(path);
  const auto odometry = writer.addTopic("/odom", "nav_msgs/msg/Odometry", "");
  const auto laser = writer.addTopic("/scan", "sensor_msgs/msg/LaserScan", "");
  for (int i = 0; i < 3; ++i) {
    const double time_s = 10.0 + i;
    FieldWriter pose = FieldWriter::cdr();
    pose.stamp(time_s);
    pose.text("odom");
    pose.text("laser");
    for (const double value : {1.0 * i, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) pose.put(value);
    writer.write(odometry, time_s, pose.bytes());
    if (!scans) continue;
    FieldWriter scan = FieldWriter::cdr();
    scan.stamp(time_s);
    scan.text("laser");
    for (const float value : {-1.0F, 1.0F, 1.0F, 0.0F, 0.0F, 0.1F, 30.0F}) scan.put(value);
    scan.count(3);
    for (const float range : {4.0F, 5.0F, 6.0F}) scan.put(range);
    scan.count(0);
    writer.write(laser, time_s, scan.bytes());
  }
  writer.finish();
}

TEST_F(BagsCli, InfoListsWhatServesAsWhat) {
  writeDrive("drive.mcap", true);
  expectDone(run({"info", "drive.mcap"}),
             "drive.mcap: MCAP of 6 messages in 2.0 s\n"
             "topic  type                   messages  rate_hz   first_s    last_s  serves_as\n"
             "/odom  nav_msgs/Odometry             3      1.0      0.00      2.00  odometry\n"
             "/scan  sensor_msgs/LaserScan         3      1.0      0.00      2.00  scan\n"
             "import: what serves as something makes a recording\n");
}

TEST_F(BagsCli, ImportMakesARecording) {
  writeDrive("drive.mcap", true);
  const Outcome outcome = run({"import", "drive.mcap", "--out", "rec"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "rec: recording of 0 pairs of images, 3 scans and 3 poses\n");
  EXPECT_NE(outcome.err.find("note: /scan as scan\n"), std::string::npos) << outcome.err;
  EXPECT_EQ(run({"validate", "rec"}).status, 0);
}

TEST_F(BagsCli, ImportSaysWhyThereIsNothingToImport) {
  writeDrive("blind.mcap", false);
  expectFailed(
      run({"import", "blind.mcap", "--out", "rec"}), 2,
      "handmap-cli: error: blind.mcap: found nothing that sees, expected scans, points or a "
      "pair of images with camera infos; it holds /odom (nav_msgs/Odometry), /scan "
      "(sensor_msgs/LaserScan)\n");
  expectFailed(run({"import", "blind.mcap", "--out", "rec", "--odometry", "/wheels"}), 2,
               "handmap-cli: error: blind.mcap: --odometry: found /wheels, expected /odom\n");
  writeText("a.bag", "no bag at all");
  expectFailed(run({"info", "a.bag"}), 2,
               "handmap-cli: error: a.bag: found another beginning, expected #ROSBAG V2.0\n");
}

/// The rows of the street's folder that are in its bag; with images of the bag where `own` is
/// false.
void writeStreetRows(const std::filesystem::path& street, const std::filesystem::path& bag,
                     const std::filesystem::path& folder, bool own) {
  constexpr double kBegin_s = 1317045941.6903532 - 6.189430;  // of the folder's times
  const auto rows = readFrameTable(street / "frames.csv");
  create_directory(folder);
  for (const char* file : {"odometry.tum", "calib.txt", "recording.json"}) {
    create_symlink(street / file, folder / file);
  }
  for (const char* images : {"image_0", "image_1"}) {
    create_directory_symlink((own ? street : absolute(bag)) / images, folder / images);
  }
  std::ofstream table(folder / "frames.csv");
  table << frameTableHeader();
  for (const FrameRow& in_bag : readFrameTable(bag / "frames.csv")) {
    if (in_bag.left.empty()) continue;
    const auto row = std::ranges::min_element(rows, {}, [&](const FrameRow& each) {
      return std::abs(each.time_s + kBegin_s - in_bag.time_s);
    });
    ASSERT_NEAR(row->time_s + kBegin_s, in_bag.time_s, 1e-3);
    FrameRow same = *row;
    same.points.clear();
    if (!own) {
      same.left = in_bag.left;
      same.right = in_bag.right;
    }
    table << formatFrameRow(same);
  }
}

/// The bag keeps the images as they are, the folder as JPEG: 2 grey values of 255 apart.
TEST_F(BagsCli, TheStreetsBagGivesTheSameRunAsItsFolder) {
  const std::filesystem::path shared = HANDMAP_SHARED_DATA;
  const std::filesystem::path file = shared / "bags/kitti_street_excerpt.bag";
  if (!exists(file)) GTEST_SKIP() << "no real recordings beside the project";
  ASSERT_EQ(run({"import", file, "--out", "bag", "--points", "none", "--quiet"}).status, 0);
  const std::filesystem::path street = absolute(shared / "street");
  writeStreetRows(street, "bag", "same-images", false);
  writeStreetRows(street, "bag", "own-images", true);
  std::map<std::string, nlohmann::json> ends;
  for (const char* recording : {"bag", "same-images", "own-images"}) {
    const Outcome outcome = run({"run", "--map", street / "sketch-a.handmap", "--recording",
                                 recording, "--json", "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    ends[recording] = nlohmann::json::parse(outcome.out);
  }
  const auto apart_m = [&](const char* recording) {
    const auto at = [&](const char* key) {
      return ends["bag"]["pose"][key].get<double>() - ends[recording]["pose"][key].get<double>();
    };
    return std::hypot(at("x"), at("y"));
  };
  EXPECT_EQ(ends["bag"]["observations"], 6);
  EXPECT_LT(apart_m("same-images"), 0.001);
  EXPECT_LT(apart_m("own-images"), 0.1);
}

TEST_F(BagsCli, EachRealBagOpensAndSaysWhatCanBeMadeOfIt) {
  const std::filesystem::path bags = std::filesystem::path(HANDMAP_SHARED_DATA) / "bags";
  if (!exists(bags)) GTEST_SKIP() << "no real recordings beside the project";
  int count = 0;
  int useful = 0;
  for (const auto& entry : std::filesystem::directory_iterator(bags)) {
    const Outcome info = run({"info", entry.path()});
    EXPECT_EQ(info.status, 0) << entry.path() << info.err;
    EXPECT_EQ(info.err, "") << "whole";
    const bool serves = info.out.ends_with("import: what serves as something makes a recording\n");
    const bool is_blind = info.out.ends_with(
        "import: nothing in it sees: no scans, no points, no pair of images with camera infos\n");
    EXPECT_TRUE(serves || is_blind) << info.out;
    const std::string out = "made-" + std::to_string(count++);
    EXPECT_EQ(run({"import", entry.path(), "--out", out, "--quiet"}).status, serves ? 0 : 2)
        << entry.path();
    useful += serves ? 1 : 0;
  }
  EXPECT_GE(count, 7);
  EXPECT_GE(useful, 1);
}

/// As power that goes leaves it: cut anywhere, before it took its place.
TEST_F(BagsCli, AnMcapThatWasCutOffIsFinishedAtTheNextStart) {
  ASSERT_EQ(run({"simulate", "--seed", "3", "--out", "world"}).status, 0);
  const auto again = [] {
    return run({"run", "--map", "world/sketch.handmap", "--recording", "world", "--mcap",
                "run.mcap", "--to", "20"});
  };
  ASSERT_EQ(again().status, 0);
  const std::string whole = contentOf("run.mcap");
  std::ofstream("run.part.mcap", std::ios::binary) << whole.substr(0, whole.size() / 2);
  const Outcome next = again();
  ASSERT_EQ(next.status, 0) << next.err;
  EXPECT_NE(next.err.find("what there is of it is run.unfinished.mcap\n"), std::string::npos)
      << next.err;
  EXPECT_TRUE(contentOf("run.mcap").ends_with("MCAP0\r\n"));
  EXPECT_TRUE(contentOf("run.unfinished.mcap").ends_with("MCAP0\r\n"));
  const Outcome info = run({"info", "run.unfinished.mcap"});
  EXPECT_EQ(info.err, "") << "nothing is cut off any more";
  EXPECT_NE(info.out.find("/pose "), std::string::npos);
}

/// By programs of others: ./dev peers gets them.
TEST_F(BagsCli, ARunAsMcapIsReadByOthers) {
  ASSERT_EQ(run({"simulate", "--seed", "3", "--out", "world"}).status, 0);
  const Outcome outcome = run({"run", "--map", "world/sketch.handmap", "--recording", "world",
                               "--mcap", "run.mcap", "--to", "20", "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(contentOf("run.mcap").ends_with("MCAP0\r\n"));
  if (!std::filesystem::exists(HANDMAP_PEERS "/node_modules/@mcap/core")) {
    GTEST_SKIP() << "no peers: ./dev peers";
  }
  const auto readByOthers = [](const std::string& file) {
    const std::string command = "NODE_PATH=" HANDMAP_PEERS "/node_modules node " HANDMAP_SOURCES
                                "/tests/cli/peers/read_mcap.cjs " +
                                file + " > read.json";
    EXPECT_EQ(std::system(command.c_str()), 0) << file;
    return nlohmann::json::parse(contentOf("read.json"));
  };
  const auto read = readByOthers("run.mcap");
  const auto frames = read["counts"]["/pose"].get<int>();
  EXPECT_GT(frames, 5);
  EXPECT_EQ(read["counts"]["/tf"], frames + 1);
  EXPECT_EQ(read["counts"]["/particles"], frames);
  EXPECT_GE(read["counts"]["/local_map"].get<int>(), 1);
  EXPECT_FALSE(read["marker"].get<std::string>().empty());
  EXPECT_TRUE(read["pose"]["x"].is_number());
  EXPECT_EQ(read["attachments"].size(), 3U);

  std::filesystem::resize_file("run.mcap", contentOf("run.mcap").size() * 3 / 4);
  EXPECT_TRUE(finishMcap("run.mcap"));
  EXPECT_GT(readByOthers("run.mcap")["counts"]["/pose"].get<int>(), 2);
}

}  // namespace
}  // namespace handmap
