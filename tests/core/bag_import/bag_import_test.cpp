#include "core/bag_import/bag_import.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/recording/recording.h"
#include "tests/core/bags/made_bags.h"
#include "tests/core/base/expect_error.h"

namespace handmap {
namespace {

using test::MadeMessage;

void putPose(FieldWriter& to, double x, double y, double z, double yaw) {
  for (const double value : {x, y, z, 0.0, 0.0, std::sin(yaw / 2), std::cos(yaw / 2)})
    to.put(value);
}

MadeMessage odometry(const std::string& topic, double time_s, double x) {
  return {topic, "nav_msgs/Odometry", time_s, [=](FieldWriter& to, MessageEncoding encoding) {
            test::header(to, encoding, time_s, "odom");
            to.text("base_link");
            putPose(to, x, 0.0, 0.0, 0.5);
            for (int i = 0; i < 36 + 6 + 36; ++i) to.put(0.0);
          }};
}

MadeMessage transform(const std::string& topic, double time_s, const std::string& parent,
                      const std::string& child, double x, double z, double yaw) {
  return {topic, "tf2_msgs/TFMessage", time_s, [=](FieldWriter& to, MessageEncoding encoding) {
            to.count(1);
            test::header(to, encoding, time_s, parent);
            to.text(child);
            putPose(to, x, 0.0, z, yaw);
          }};
}

/// Four rays: 1 m ahead, nothing, too near, 2 m behind.
MadeMessage scan(double time_s) {
  return {"/scan", "sensor_msgs/LaserScan", time_s, [=](FieldWriter& to, MessageEncoding encoding) {
            test::header(to, encoding, time_s, "laser");
            constexpr auto kQuarter = static_cast<float>(kPi / 2);
            for (const float value : {0.0F, 3 * kQuarter, kQuarter, 0.1F, 0.4F, 0.2F, 30.0F}) {
              to.put(value);
            }
            to.count(4);
            for (const float range : {1.0F, INFINITY, 2.0F, 0.1F}) to.put(range);
            to.count(0);
          }};
}

MadeMessage image(const std::string& topic, double time_s, std::uint8_t shade) {
  return {topic, "sensor_msgs/Image", time_s, [=](FieldWriter& to, MessageEncoding encoding) {
            test::header(to, encoding, time_s, "camera");
            to.put(std::uint32_t{4});
            to.put(std::uint32_t{6});
            to.text("mono8");
            to.put(std::uint8_t{0});
            to.put(std::uint32_t{6});
            to.sized<std::uint32_t>(std::string(24, static_cast<char>(shade)));
          }};
}

MadeMessage cameraInfo(const std::string& topic, double time_s, double shift) {
  return {
      topic, "sensor_msgs/CameraInfo", time_s, [=](FieldWriter& to, MessageEncoding encoding) {
        test::header(to, encoding, time_s, "camera");
        to.put(std::uint32_t{4});
        to.put(std::uint32_t{6});
        to.text("plumb_bob");
        to.count(5);
        for (int i = 0; i < 5; ++i) to.put(0.0);
        for (const double k : {10.0, 0.0, 3.0, 0.0, 10.0, 2.0, 0.0, 0.0, 1.0}) to.put(k);
        for (const double r : {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) to.put(r);
        for (const double p : {10.0, 0.0, 3.0, shift, 0.0, 10.0, 2.0, 0.0, 0.0, 0.0, 1.0, 0.0}) {
          to.put(p);
        }
        for (int i = 0; i < 6; ++i) to.put(std::uint32_t{0});
        to.put(std::uint8_t{0});
      }};
}

std::vector<MadeMessage> drive(bool frames_alone = false) {
  std::vector<MadeMessage> messages = {
      transform("/tf_static", 10.0, "base_link", "laser", 0.5, 0.3, kPi / 2),
      transform("/tf_static", 10.0, "base_footprint", "base_link", 0.0, 0.1, 0.0)};
  for (int i = 0; i < 4; ++i) {
    const double time_s = 10.0 + i;
    messages.push_back(frames_alone ? transform("/tf", time_s, "odom", "base_link", i, 0.0, 0.5)
                                    : odometry("/odom", time_s, i));
    messages.push_back(odometry("/ground_truth", time_s, i + 0.1));
    if (i < 3) messages.push_back(scan(time_s + 0.25));
  }
  return messages;
}

class BagImport : public testing::Test {
 protected:
  ImportedBag import(const std::filesystem::path& path, const ToldTopics& told = {}) {
    const auto bag = openBag(path);
    notes_.clear();
    std::filesystem::remove_all(out());
    return importBag(*bag, planOf(*bag, told), out(), "drive", notes_);
  }
  std::filesystem::path out() const { return folder_.path() / "out"; }
  bool noted(const std::string& words) const {
    return std::ranges::any_of(
        notes_, [&](const std::string& note) { return note.find(words) != std::string::npos; });
  }

  test::TemporaryFolder folder_;
  std::vector<std::string> notes_;
};

TEST_F(BagImport, OfEachKindMakesTheSameRecording) {
  test::writeMcap(folder_.path() / "a.mcap", drive());
  test::writeSqlite(folder_.path() / "a.db3", drive());
  folder_.write("a.bag", test::ros1Bag(drive(), "lz4"));
  std::vector<std::string> tables;
  for (const char* name : {"a.bag", "a.mcap", "a.db3"}) {
    const ImportedBag imported = import(folder_.path() / name);
    EXPECT_EQ(imported.scans, 3U);
    EXPECT_EQ(imported.poses, 4U);
    const Recording recording = openRecording(out());
    ASSERT_EQ(recording.rows.size(), 3U);
    EXPECT_DOUBLE_EQ(recording.range_limit_m, 30.0);
    EXPECT_NEAR(recording.rows[1].time_s, 11.45, 1e-7);  // the middle of a scan that takes 0.4 s
    const auto pose = recording.odometry.at(11.5);
    ASSERT_TRUE(pose);
    EXPECT_NEAR(pose->x, 1.5, 1e-5);
    EXPECT_NEAR(pose->heading, 0.5, 1e-5);
    EXPECT_NEAR(recording.truth.at(12.0)->x, 2.1, 1e-5);
    const auto points = readPoints(out() / recording.rows[0].points);
    ASSERT_EQ(points.size(), 3U);
    // 1 m ahead of a scanner that looks to the left from 0.5 m ahead and 0.4 m above the ground.
    EXPECT_NEAR(points[0].x, 0.5, 1e-5);
    EXPECT_NEAR(points[0].y, 1.0, 1e-5);
    EXPECT_NEAR(points[0].z, 0.4, 1e-5);
    EXPECT_TRUE(isMeasured(points[1]));
    EXPECT_FALSE(isMeasured(points[2]));  // nearer than it measures: a direction, to the front
    EXPECT_GT(points[2].x, 0.0F);
    tables.push_back(readFile(out() / "frames.csv", 1 << 20) +
                     readFile(out() / "odometry.tum", 1 << 20));
    EXPECT_EQ(tables.back(), tables.front()) << name;
  }
}

TEST_F(BagImport, TakesFramesForOdometryWhereThereIsNone) {
  folder_.write("a.bag", test::ros1Bag(drive(true), "none"));
  EXPECT_EQ(import(folder_.path() / "a.bag").poses, 4U);
  EXPECT_NEAR(openRecording(out()).odometry.at(11.5)->x, 1.5, 1e-5);
}

TEST_F(BagImport, TakesTheTopicsThatAPersonSays) {
  test::writeMcap(folder_.path() / "a.mcap", drive());
  import(folder_.path() / "a.mcap", {{"odometry", "/ground_truth"}, { "truth", "none" }});
  const Recording recording = openRecording(out());
  EXPECT_NEAR(recording.odometry.at(12.0)->x, 2.1, 1e-5);
  EXPECT_TRUE(recording.truth.empty());
  const auto refused = [&] { import(folder_.path() / "a.mcap", {{ "scan", "/odom" }}); };
  test::expectBadInput(refused, {"--scan", "/odom", "/scan"});
}

TEST_F(BagImport, PutsTheSensorWhereAPersonSays) {
  test::writeMcap(folder_.path() / "a.mcap", drive());
  import(folder_.path() / "a.mcap", {{ "sensor", "-2, 1, 1.5, 180" }});
  const auto points = readPoints(out() / openRecording(out()).rows[0].points);
  EXPECT_NEAR(points[0].x, -3.0, 1e-5);  // 1 m ahead of a scanner that looks back
  EXPECT_NEAR(points[0].y, 1.0, 1e-5);
  EXPECT_NEAR(points[0].z, 1.5, 1e-5);
  EXPECT_LT(points[2].x, 0.0F) << "a direction";
  for (const char* wrong : {"1,2", "1,2,3,4,5", "1,2,x", "1,2,999", "1,2,3,nan", ""}) {
    try {
      import(folder_.path() / "a.mcap", {{ "sensor", wrong }});
      ADD_FAILURE() << wrong;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::Usage);
      EXPECT_NE(std::string(error.what()).find("X,Y,Z"), std::string::npos);
    }
  }
}

TEST_F(BagImport, PairsImagesAndTakesTheCameraFromItsInfos) {
  auto messages = drive();
  messages.push_back(transform("/tf_static", 10.0, "base_link", "camera", 0.2, 1.0, 0.0));
  for (int i = 0; i < 3; ++i) {
    const double time_s = 10.25 + i;
    messages.push_back(cameraInfo("/stereo/left/camera_info", time_s, 0.0));
    messages.push_back(cameraInfo("/stereo/right/camera_info", time_s, -5.0));
    messages.push_back(image("/stereo/right/image_rect", time_s + 0.002, 20));
    messages.push_back(image("/stereo/left/image_rect", time_s, 10));
  }
  messages.push_back(image("/stereo/left/image_rect", 12.9, 10));  // without another
  test::writeMcap(folder_.path() / "a.mcap", messages);
  const ImportedBag imported = import(folder_.path() / "a.mcap");
  EXPECT_EQ(imported.pairs, 3U);
  EXPECT_EQ(imported.scans, 3U);
  const Recording recording = openRecording(out());
  ASSERT_TRUE(recording.camera);
  EXPECT_NEAR(recording.camera->baseline, 0.5, 1e-9);
  EXPECT_NEAR(recording.camera->cx, 3.0, 1e-9);
  EXPECT_NEAR(recording.camera->mount.z, 1.1, 1e-6);
  EXPECT_EQ(recording.rows.size(), 6U);
}

TEST_F(BagImport, SaysWhatABagHoldsInWhichNothingSees) {
  test::writeMcap(folder_.path() / "a.mcap", {odometry("/odom", 1.0, 0.0)});
  test::expectBadInput([&] { import(folder_.path() / "a.mcap"); },
                       {"a.mcap", "/odom (nav_msgs/Odometry)"});
}

TEST_F(BagImport, PassesOverDamagedMessages) {
  auto messages = drive();
  messages.push_back(
      {"/scan", "sensor_msgs/LaserScan", 12.9, [](FieldWriter& to, MessageEncoding encoding) {
         test::header(to, encoding, 12.9, "laser");
         to.put(1.0F);
       }});
  test::writeMcap(folder_.path() / "a.mcap", messages);
  EXPECT_EQ(import(folder_.path() / "a.mcap").scans, 3U);
  EXPECT_TRUE(noted("/scan"));
}

TEST_F(BagImport, OfWhichNothingCanBeReadIsRefused) {
  auto messages = drive();
  std::erase_if(messages, [](const MadeMessage& message) { return message.topic == "/scan"; });
  messages.push_back(
      {"/scan", "sensor_msgs/LaserScan", 12.0, [](FieldWriter& to, MessageEncoding encoding) {
         test::header(to, encoding, 12.0, "laser");
       }});
  test::writeMcap(folder_.path() / "a.mcap", messages);
  test::expectBadInput([&] { import(folder_.path() / "a.mcap"); }, {"a.mcap", "/scan"});
}

TEST(RealBagImport, TheStreetIsThatOfItsFolder) {
  const std::filesystem::path data = HANDMAP_SHARED_DATA;
  if (!std::filesystem::exists(data / "bags")) GTEST_SKIP() << "no ../shared/data/bags";
  const test::TemporaryFolder folder;
  const auto bag = openBag(data / "bags" / "kitti_street_excerpt.bag");
  std::vector<std::string> notes;
  const auto out = folder.path() / "street";
  const ImportedBag imported = importBag(*bag, planOf(*bag, {}), out, "street", notes);
  EXPECT_EQ(imported.pairs, 6U);
  EXPECT_EQ(imported.scans, 6U);
  EXPECT_EQ(imported.poses, 41U);
  const Recording made = openRecording(out);
  const Recording street = openRecording(data / "street");
  EXPECT_NEAR(made.camera->fx, street.camera->fx, 1e-3);
  EXPECT_NEAR(made.camera->baseline, street.camera->baseline, 1e-4);
}

}  // namespace
}  // namespace handmap
