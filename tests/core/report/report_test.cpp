#include "core/report/report.h"

#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/core/base/expect_error.h"

namespace handmap {
namespace {

Building house(const std::string& id, double x) {
  Building building;
  building.id = id;
  building.shape = Rectangle{{x, 10.0}, 10.0, 8.0, 0.0};
  return building;
}

ReportInputs inputs() {
  ReportInputs made;
  made.drawing.name = "</script><b>Our street</b>";
  made.drawing.buildings = {house("A", 0.0), house("B_1", 30.0)};
  made.refined = made.drawing;
  Building& found = made.refined.buildings[0];
  found.shape = Rectangle{{3.0, 14.0}, 10.0, 8.0, 0.0};
  found.estimate = Estimate{0.2, 0.2, 0.2, 9};
  found.sides = Sides{SideEstimate{0.3, true}, SideEstimate{5.0, false}, SideEstimate{5.0, false},
                      SideEstimate{0.15, true}};
  found.doubt = 0.1;
  made.run_file = "report.json";
  made.run = R"({"settings":{"seed":1},"warnings":[{"code":"w","message":"Too dark."}],"frames":[
    {"frame":0,"time_s":0,"pose":[0,0,0],"pose_sigma":[0.1,0.1,0.01]},
    {"frame":1,"time_s":1,"pose":[1,0,0],"pose_sigma":[0.1,0.2,0.01]}]})";
  return made;
}

nlohmann::json dataOf(const std::string& page) {
  const std::string begin = "type=\"application/json\">";
  const std::size_t at = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
}

TEST(Tolerances, TellHowProbablyAWallIsWithin) {
  const auto walls = tolerancesOf(inputs().refined);
  ASSERT_EQ(walls.size(), 4U);
  EXPECT_TRUE(walls[0].seen);
  EXPECT_NEAR(walls[0].within[0], 0.97 * 0.9 * 0.6827, 1e-3);  // one σ, if it is there at all
  EXPECT_NEAR(walls[0].within[1], 0.97 * 0.9 * 0.9545, 1e-3);
  EXPECT_LT(walls[1].within[2], 0.2);
}

TEST(Tolerances, AreTables) {
  const std::string csv = tolerancesCsv(inputs().refined);
  EXPECT_NE(csv.find("\nA,0,0.300,1,0.596,0.833,0.873\n"), std::string::npos) << csv;
  Map map = inputs().refined;
  map.buildings[0].id = "a_1,\"b\"";
  EXPECT_NE(tolerancesCsv(map).find("\n\"a_1,\"\"b\"\"\",0,"), std::string::npos);
  EXPECT_NE(tolerancesLatex(map).find("\na\\_1,\"b\" & 0 & 0.30 & yes"), std::string::npos);
}

TEST(Report, HoldsWhatItShowsAndTheData) {
  const std::string page = reportHtml(inputs());
  const auto data = dataOf(page);
  EXPECT_EQ(data["title"], "</script><b>Our street</b>");
  EXPECT_EQ(data["buildings"].size(), 2U);
  EXPECT_DOUBLE_EQ(data["buildings"][0]["moved_m"].get<double>(), 5.0);
  EXPECT_EQ(data["frames"][1][5], 0.2);
  EXPECT_EQ(data["run"]["warnings"][0]["message"], "Too dark.");
  EXPECT_TRUE(data["files"].contains("refined.handmap"));
  EXPECT_EQ(data["files"]["report.json"], inputs().run);
}

TEST(Report, RefersToNothingOutside) {
  const std::string page = reportHtml(inputs());
  const std::regex outside(R"((src|href)\s*=\s*["']?(https?:|//)|@import|url\()");
  EXPECT_FALSE(std::regex_search(page, outside));
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  // The one address is the name of a language, not a place.
  std::size_t addresses = 0;
  for (std::size_t at = 0; (at = page.find("http://", at)) != std::string::npos; ++at) ++addresses;
  EXPECT_EQ(addresses, 1U);
  EXPECT_EQ(page.find("https://"), std::string::npos);
}

TEST(Report, RefusesWhatIsNoReportOfARun) {
  ReportInputs wrong = inputs();
  wrong.run = R"({"frames":[]})";
  test::expectBadInput([&] { reportHtml(wrong); }, {"report.json", "frames"});
  wrong.run = R"({"frames":[{"time_s":0,"pose":[1],"pose_sigma":[1,2,3]}]})";
  test::expectBadInput([&] { reportHtml(wrong); }, {"report.json", "frames[0].pose"});
  wrong.run = "{";
  test::expectBadInput([&] { reportHtml(wrong); }, {"report.json"});
}

}  // namespace
}  // namespace handmap
