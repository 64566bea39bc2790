#include "core/run_log/run_log.h"

#include <gtest/gtest.h>

#include "core/bags/mcap_writer.h"
#include "core/bags/ros_definitions.h"
#include "core/bags/ros_messages.h"
#include "core/run_log/ros_writing.h"
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

/// Wherever it was cut, others read what there is, and no frame that was whole is lost.
TEST(RunLog, OneThatWasCutOffIsFinishedAtTheNextStart) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "run.mcap";
  EXPECT_FALSE(keepUnfinished(path));
  {
    McapWriter writer(runPartOf(path));
    const auto topic = writer.addTopic("/pose", "geometry_msgs/msg/PoseStamped",
                                       rosDefinition("geometry_msgs/msg/PoseStamped"));
    for (int i = 0; i < 10; ++i) {
      writer.write(topic, 2.0 * i, ros::pose({2.0 * i, "map"}, Pose2{1.0 * i, 0.0, 0.0}));
    }
  }
  const std::string all = folder.read("run.part.mcap");
  const auto messages = [&](const std::filesystem::path& file) {
    const auto bag = openBag(file);
    EXPECT_TRUE(bag->notes().empty()) << "whole";
    return bag->topics().empty() ? 0U : bag->topics()[0].messages;
  };
  std::size_t before = 0;
  for (std::size_t bytes = 60; bytes <= all.size(); bytes += 7) {
    folder.write("run.part.mcap", std::string_view(all).substr(0, bytes));
    const auto kept = keepUnfinished(path);
    ASSERT_EQ(kept, folder.path() / "run.unfinished.mcap");
    EXPECT_FALSE(exists(runPartOf(path)));
    EXPECT_FALSE(finishMcap(*kept)) << "nothing more to do";
    const std::size_t now = messages(*kept);
    EXPECT_GE(now, before) << bytes;
    before = now;
  }
  EXPECT_EQ(before, 9U) << "the last second was not written when the program ended";
  folder.write("run.part.mcap", "something else");
  EXPECT_FALSE(keepUnfinished(path));
}

}  // namespace
}  // namespace handmap
