#include "core/run_log/run_log.h"

#include <gtest/gtest.h>

#include "core/bags/ros_definitions.h"
#include "core/bags/ros_messages.h"
#include "core/run_log/run_part.h"
#include "core/simulation/simulated_source.h"
#include "core/simulation/world.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

TEST(RosDefinitions, SpellOutWhatIsWithin) {
  const std::string text = rosDefinition("geometry_msgs/msg/PoseStamped");
  EXPECT_TRUE(text.starts_with("std_msgs/Header header\ngeometry_msgs/Pose pose\n"));
  for (const char* type : {"std_msgs/Header", "builtin_interfaces/Time", "geometry_msgs/Point"}) {
    EXPECT_NE(text.find(std::string("\nMSG: ") + type + "\n"), std::string::npos) << type;
  }
}

TEST(RunLog, HoldsTheRun) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "run.mcap";
  const World world = twoRowWorld(3);
  RunSettings settings;
  settings.threads = 1;
  auto source = simulate(world, {}, 3);
  RunLog log(path, world.map, source->info());
  RunSession session(world.map, std::move(source), settings);
  int frames = 0;
  Pose2 last;
  for (; frames < 5; ++frames) {
    const auto snapshot = session.step();
    ASSERT_TRUE(snapshot);
    log.add(*snapshot);
    log.add(*snapshot);  // the same again
    last = snapshot->report.pose;
  }
  EXPECT_FALSE(exists(path)) << "an older one stays until this one is whole";
  EXPECT_TRUE(openBag(runPartOf(path))->notes().empty()) << "it can be read at any time";
  log.finish(session.refinedMap(), session.trajectory(), session.warnings());

  const auto bag = openBag(path);
  EXPECT_TRUE(bag->notes().empty());
  std::size_t pose_topic = 0;
  std::map<std::string, std::size_t> messages;
  for (std::size_t i = 0; i < bag->topics().size(); ++i) {
    messages[bag->topics()[i].name] = bag->topics()[i].messages;
    if (bag->topics()[i].name == "/pose") pose_topic = i;
  }
  EXPECT_EQ(messages["/pose"], 5U);
  EXPECT_EQ(messages["/tf"], 6U);
  EXPECT_EQ(messages["/drawing"], 1U);
  EXPECT_GE(messages["/buildings"], 2U);
  EXPECT_GE(messages["/local_map"], 1U);
  std::vector<bool> wanted(bag->topics().size(), false);
  wanted[pose_topic] = true;
  ros::Pose read;
  bag->read(wanted,
            [&](const BagMessage& message) {
              read = ros::readPose(bag->fieldsOf(message), bag->topics()[message.topic]);
            },
            {});
  EXPECT_EQ(read.header.frame, "map");
  EXPECT_NEAR(read.pose.translation().x(), last.x, 1e-9);
}

}  // namespace
}  // namespace handmap
