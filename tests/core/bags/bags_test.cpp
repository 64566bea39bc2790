#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/bags/bag.h"
#include "core/bags/mcap_format.h"
#include "core/base/text.h"
#include "tests/core/bags/made_bags.h"
#include "tests/core/base/expect_error.h"

namespace handmap {
namespace {

std::vector<test::MadeMessage> twoTopics() {
  std::vector<test::MadeMessage> messages;
  for (int i = 0; i < 10; ++i) {
    messages.push_back({i % 5 == 0 ? "/slow" : "/fast", "std_msgs/String", 100.0 + i,
                        [i](FieldWriter& to, MessageEncoding) {
                          to.text(fmt::format("{}", i));
                          to.put(0.5 * i);
                        }});
  }
  return messages;
}

class Bags : public testing::Test {
 protected:
  std::filesystem::path made(const std::string& kind) const {
    if (kind == "mcap") {
      const auto path = folder_.path() / "a.mcap";
      test::writeMcap(path, twoTopics());
      return path;
    }
    if (kind == "db3") {
      const auto path = folder_.path() / "a.db3";
      test::writeSqlite(path, twoTopics());
      return path;
    }
    return folder_.write("a.bag", test::ros1Bag(twoTopics(), kind));
  }
  static std::vector<std::pair<std::string, double>> all(const Bag& bag) {
    std::vector<std::pair<std::string, double>> read;
    const std::vector<bool> wanted(bag.topics().size(), true);
    bag.read(wanted,
             [&](const BagMessage& message) {
               FieldReader fields = bag.fieldsOf(message);
               std::string text = fields.text();
               EXPECT_EQ(fields.get<double>() + 100.0 + 0.5 * std::stod(text), message.time_s);
               read.emplace_back(std::move(text), message.time_s);
             },
             {});
    return read;
  }

  static std::size_t counted(const Bag& bag) {
    std::size_t count = 0;
    bag.read(std::vector<bool>(bag.topics().size(), true), [&](const BagMessage&) { ++count; }, {});
    return count;
  }

  test::TemporaryFolder folder_;
};

class BagKinds : public Bags, public testing::WithParamInterface<const char*> {};

TEST_P(BagKinds, GiveWhatIsInThem) {
  const auto bag = openBag(made(GetParam()));
  ASSERT_EQ(bag->topics().size(), 2U);
  EXPECT_EQ(bag->topics()[0].name, "/slow");
  EXPECT_EQ(bag->topics()[0].type, "std_msgs/String");
  EXPECT_EQ(bag->topics()[0].messages, 2U);
  EXPECT_EQ(bag->topics()[1].messages, 8U);
  EXPECT_NEAR(bag->topics()[1].first_s, 101.0, 1e-6);
  EXPECT_NEAR(bag->topics()[1].last_s, 109.0, 1e-6);
  EXPECT_TRUE(bag->notes().empty());
  const auto messages = all(*bag);
  ASSERT_EQ(messages.size(), 10U);
  EXPECT_EQ(messages[7].first, "7");
}

TEST_P(BagKinds, CutOffGiveWhatIsWholeOrSayWhere) {
  const std::string whole = readFile(made(GetParam()), 1 << 24);
  const std::string ending = made(GetParam()).extension().string();
  std::size_t most = 0;
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 150) {
    const auto path = folder_.write("cut" + ending, whole.substr(0, size));
    try {
      const auto bag = openBag(path);
      const std::size_t count = counted(*bag);
      EXPECT_GE(count, ending == ".db3" ? 0 : most);
      most = count;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::BadInput);
      EXPECT_NE(std::string(error.what()).find("cut"), std::string::npos) << error.what();
    }
  }
  EXPECT_GE(most, ending == ".db3" ? 0U : 8U);
}

TEST_P(BagKinds, DamagedAreReadOrRefused) {
  const std::string whole = readFile(made(GetParam()), 1 << 24);
  const std::string ending = made(GetParam()).extension().string();
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 200) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(~damaged[at]);
    const auto path = folder_.write("damaged" + ending, damaged);
    try {
      const auto bag = openBag(path);
      counted(*bag);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::BadInput);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, BagKinds, testing::Values("none", "bz2", "lz4", "mcap", "db3"));

TEST_F(Bags, WithoutAnIndexAreReadThrough) {
  const auto bag = openBag(folder_.write("a.bag", test::ros1Bag(twoTopics(), "bz2", false)));
  EXPECT_EQ(bag->topics()[1].messages, 8U);
  EXPECT_EQ(all(*bag).size(), 10U);
}

TEST_F(Bags, AnMcapIsWholeAfterEachChunk) {
  const auto path = folder_.path() / "run.mcap";
  McapWriter writer(path);
  const auto topic = writer.addTopic("/fast", "std_msgs/msg/String", "string data");
  for (const auto& message : twoTopics()) {
    writer.write(topic, message.time_s, message.bytes(MessageEncoding::Cdr));
  }
  const std::string content = readFile(path, 1 << 24);
  EXPECT_TRUE(content.ends_with(kMcapMagic));
  const auto bag = openBag(path);
  EXPECT_TRUE(bag->notes().empty());
  EXPECT_GE(all(*bag).size(), 8U);  // the last second is not written yet
}

TEST_F(Bags, AnMcapWhoseChunkIsDamagedSaysWhich) {
  std::string content = readFile(made("mcap"), 1 << 24);
  const std::size_t at = content.find("zstd");
  content[at - 5] = static_cast<char>(~content[at - 5]);  // of the checksum
  test::expectBadInput([&] { all(*openBag(folder_.write("b.mcap", content))); },
                       {"b.mcap", "chunk"});
}

TEST_F(Bags, OfAFolderAreOne) {
  const auto parts = folder_.path() / "parts";
  std::filesystem::create_directory(parts);
  test::writeSqlite(parts / "parts_10.db3", {twoTopics()[9]});
  test::writeSqlite(parts / "parts_2.db3", {twoTopics()[1], twoTopics()[5]});
  const auto bag = openBag(parts);
  const auto messages = all(*bag);
  ASSERT_EQ(messages.size(), 3U);
  EXPECT_EQ(messages[2].first, "9");
  EXPECT_EQ(bag->topics()[0].messages, 2U);
}

TEST_F(Bags, ThatAreNoneAreRefused) {
  for (const char* name : {"a.bag", "a.mcap", "a.db3"}) {
    test::expectBadInput([&] { openBag(folder_.write(name, "PK something else")); }, {name});
    test::expectBadInput([&] { openBag(folder_.write(name, "")); }, {name});
  }
  EXPECT_FALSE(isBag(folder_.write("a.csv", "1,2")));
  EXPECT_FALSE(isBag(folder_.path() / "nowhere"));
}

TEST(RealBags, AllOpen) {
  const std::filesystem::path bags = HANDMAP_SHARED_DATA "/bags";
  if (!std::filesystem::exists(bags)) GTEST_SKIP() << "no ../shared/data/bags";
  const std::map<std::string, std::pair<std::size_t, std::size_t>> expected = {
      {"kitti_street_excerpt.bag", {7, 112}},  {"foxglove_example.bag", {9, 8647}},
      {"foxglove_example-bz2.bag", {9, 8647}}, {"foxglove_example-lz4.bag", {9, 8647}},
      {"evo_tf_example.bag", {2, 518}},        {"evo_tf_example_ros2", {2, 518}},
      {"evo_nav2_turtlebot.mcap", {4, 8197}}};
  for (const auto& [name, counts] : expected) {
    const auto bag = openBag(bags / name);
    std::size_t listed = 0;
    for (const BagTopic& topic : bag->topics()) listed += topic.messages;
    std::size_t read = 0;
    bag->read(std::vector<bool>(bag->topics().size(), true), [&](const BagMessage&) { ++read; },
              {});
    EXPECT_EQ(listed, read) << name;
    EXPECT_EQ(bag->topics().size(), counts.first) << name;
    EXPECT_EQ(read, counts.second) << name;
  }
}

}  // namespace
}  // namespace handmap
