#include "core/session/acts.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

std::vector<Act> everyKind() {
  Act here{1.5, Act::Kind::RobotIsHere, {1.0, -2.0, 0.5}, {}, {}};
  Act box{2.0, Act::Kind::BuildingIsRight, {}, "L3", Rectangle{{4.0, 5.0}, 6.0, 7.0, 0.25}};
  Act outline{
      3.0, Act::Kind::BuildingIsRight, {}, "Ü \"4\"", Polygon{{0.0, 0.0}, {10.0, 0.0}, {0.0, 5.0}}};
  Act gone{4.0, Act::Kind::BuildingIsNotThere, {}, "N1", {}};
  Act forgotten{5.0, Act::Kind::ForgetPoses, {}, {}, {}};
  return {here, box, outline, gone, forgotten};
}

TEST(Acts, ComeBackAsTheyWereSaid) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(readActs(folder.path()).empty());
  for (const Act& act : everyKind()) appendAct(folder.path(), act);
  const std::vector<Act> acts = readActs(folder.path());
  ASSERT_EQ(acts.size(), 5U);
  for (std::size_t i = 0; i < acts.size(); ++i) {
    EXPECT_EQ(formatAct(acts[i]), formatAct(everyKind()[i]));
    EXPECT_EQ(acts[i].kind, everyKind()[i].kind);
    EXPECT_EQ(acts[i].building, everyKind()[i].building);
  }
  EXPECT_NEAR(acts[0].pose.heading, 0.5, 1e-12);
}

TEST(Acts, ALineThatWasNeverFinishedIsPassedOver) {
  const test::TemporaryFolder folder;
  for (const Act& act : everyKind()) appendAct(folder.path(), act);
  const std::filesystem::path file = folder.path() / kActsFile;
  const auto whole = std::filesystem::file_size(file);
  std::filesystem::resize_file(file, whole - 3);
  EXPECT_EQ(readActs(folder.path()).size(), 4U);
}

TEST(Acts, OfNonsenseTheLineIsTold) {
  for (
      const auto& [line, told] : std::vector<std::pair<std::string, std::string>>{
          {R"({"act":"forget_poses"})", "time_s"},
          {R"({"time_s":1,"act":"dance"})", "act: found \"dance\""},
          {R"({"time_s":1,"act":"robot_is_here","x":1e9,"y":0,"heading_deg":0})", "x: found"},
          {R"({"time_s":1,"act":"building_is_right","building":"A","vertices":[[0,0],[1,1]]})",
           "vertices"},
          {R"({"time_s":1,"act":"building_is_right","building":"A","vertices":[[0,0],[2,2],[2,0],[0,2]]})",
           "vertices"},
          {"nonsense", "acts.jsonl"}}) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / kActsFile)
        << formatAct({0.0, Act::Kind::ForgetPoses, {}, {}, {}}) << line << "\n";
    try {
      readActs(folder.path());
      ADD_FAILURE() << line;
    } catch (const Error& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("acts.jsonl: line 2"), std::string::npos) << text;
      EXPECT_NE(text.find(told), std::string::npos) << text;
    }
  }
}

TEST(Acts, AFolderThatIsGoneIsSaid) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(appendAct(folder.path() / "none", {}), Error);
}

}  // namespace
}  // namespace handmap
