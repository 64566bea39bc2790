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
  const auto walls = tolerancesOf(inputs().drawing, inputs().refined);
  ASSERT_EQ(walls.size(), 4U);
  EXPECT_TRUE(walls[0].seen);
  EXPECT_NEAR(walls[0].within[0], 0.9 * 0.6827, 1e-3);  // one σ, if it is there at all
  EXPECT_NEAR(walls[0].within[1], 0.9 * 0.9545, 1e-3);
  EXPECT_LT(walls[1].within[2], 0.2);
}

TEST(Tolerances, AreTables) {
  const std::string csv = tolerancesCsv(inputs().drawing, inputs().refined);
  EXPECT_NE(csv.find("\nA,0,0.300,1,0.614,0.859,0.900\n"), std::string::npos) << csv;
  Map map = inputs().refined;
  map.buildings[0].id = "a_1,\"b\"";
  EXPECT_NE(tolerancesCsv(inputs().drawing, map).find("\n\"a_1,\"\"b\"\"\",0,"), std::string::npos);
  EXPECT_NE(tolerancesLatex(inputs().drawing, map).find("\na\\_1,\"b\" & 0 & 0.30 & yes"),
            std::string::npos);
}

TEST(Tolerances, SayWhatEachColumnMeans) {
  for (const auto& [table, mark] :
       {std::pair(tolerancesCsv(inputs().drawing, inputs().refined), "# "),
        {tolerancesLatex(inputs().drawing, inputs().refined), "% "}}) {
    for (const char* word : {"side:", "sigma:", "seen:", "probability"}) {
      const std::size_t at = table.find(word);
      ASSERT_NE(at, std::string::npos) << word;
      EXPECT_EQ(table.compare(table.rfind('\n', at) + 1, 2, mark), 0) << word;
    }
  }
}

TEST(Tolerances, OfAWallAreOfThatWall) {
  const Building truth = house("A", 0.0);  // 10 m along x, 8 m deep
  Building found = truth;
  found.shape = Rectangle{{1.0, 10.0}, 12.0, 8.5, 0.0};  // ahead by 2 m, behind as it is
  EXPECT_NEAR(wallOffset(found, truth, 0), 2.0, 1e-9);
  EXPECT_NEAR(wallOffset(found, truth, 1), 0.25, 1e-9);
  EXPECT_NEAR(wallOffset(found, truth, 2), 0.0, 1e-9);
  EXPECT_NEAR(wallOffset(found, truth, 3), 0.25, 1e-9);
  found.shape = Rectangle{{1.0, 10.0}, 8.5, 12.0, -kPi / 2.0};  // the same with other names
  EXPECT_NEAR(wallOffset(found, truth, 1), 2.0, 1e-9);
  EXPECT_NEAR(wallOffset(found, truth, 3), 0.0, 1e-9);
}

TEST(Report, TellsWhatSurveyorsState) {
  ReportInputs made = inputs();
  EXPECT_FALSE(dataOf(reportHtml(made)).contains("survey"));
  made.truth = made.drawing;
  made.truth->buildings[0].shape = Rectangle{{3.5, 14.0}, 10.0, 8.0, 0.0};
  made.truth->buildings.push_back(house("C", 90.0));
  const Survey survey = surveyOf(made.drawing, made.refined, *made.truth);
  EXPECT_EQ(survey.buildings, 3);
  EXPECT_EQ(survey.present, 2);
  EXPECT_EQ(survey.walls, 2);  // ahead and to the right
  EXPECT_NEAR(survey.rms_before_m, std::sqrt((3.5 * 3.5 + 4.0 * 4.0) / 2.0), 1e-9);
  EXPECT_NEAR(survey.rms_after_m, std::sqrt(0.5 * 0.5 / 2.0), 1e-9);
  EXPECT_EQ(survey.within_before, (std::array{0, 0, 0}));
  EXPECT_EQ(survey.within_after, (std::array{1, 2, 2}));
  EXPECT_EQ(dataOf(reportHtml(made))["survey"]["present"], 2);
  EXPECT_NE(reportPdf(made).find("completeness 67 %"), std::string::npos);
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

TEST(Report, HoldsParticlesAndNotTooMany) {
  ReportInputs made = inputs();
  made.particles = {{0.0, {{1.234, 5.0}}}, {1.0, std::vector<Vec2>(1000, Vec2(2.0, 3.0))}};
  const auto clouds = dataOf(reportHtml(made))["particles"];
  ASSERT_EQ(clouds.size(), 2U);
  EXPECT_EQ(clouds[0][0], 0.0);
  EXPECT_NEAR(clouds[0][1].get<double>(), 1.23, 1e-9);
  EXPECT_LE(clouds[1].size(), 201U);
  made.particles.resize(5000);
  EXPECT_LE(dataOf(reportHtml(made))["particles"].size(), 400U);
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

/// Each object is where the table of the file says.
void expectWhole(const std::string& pdf) {
  ASSERT_TRUE(pdf.starts_with("%PDF-1.4\n"));
  const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
  ASSERT_EQ(pdf.compare(table, 5, "xref\n"), 0);
  const std::size_t count = std::stoul(pdf.substr(table + 7));
  for (std::size_t i = 1; i < count; ++i) {
    const std::size_t row = pdf.find("65535 f \n", table) + 9 + 20 * (i - 1);
    EXPECT_EQ(pdf.compare(std::stoul(pdf.substr(row, 10)), 6, std::to_string(i) + " 0 ob", 0, 6), 0)
        << i;
  }
}

TEST(ReportPdf, HasPlanTableAndWhatWentWrong) {
  ReportInputs made = inputs();
  made.drawing.name = "Our (small) street";
  const std::string pdf = reportPdf(made);
  expectWhole(pdf);
  for (const char* text : {"(Our \\(small\\) street) Tj", "(5.00 m) Tj", "(10 %) Tj", "(0.61) Tj",
                           "(Too dark.) Tj", "(seed: 1) Tj"}) {
    EXPECT_NE(pdf.find(text), std::string::npos) << text;
  }
}

TEST(ReportPdf, HasAsManyPagesAsItNeeds) {
  ReportInputs made = inputs();
  for (int i = 0; i < 60; ++i) {
    made.refined.buildings.push_back(made.refined.buildings[0]);
    made.refined.buildings.back().id = "C" + std::to_string(i);
  }
  const std::string pdf = reportPdf(made);
  expectWhole(pdf);
  EXPECT_NE(pdf.find("/Count 6>>"), std::string::npos) << pdf.substr(pdf.find("/Count"), 12);
}

TEST(ReportPdf, NamesOfAnyScript) {
  ReportInputs made = inputs();
  made.refined.buildings[0].name = "\xE9\xA7\x85\xFF";  // a station, and no character
  EXPECT_NE(reportPdf(made).find("<99C5> Tj"), std::string::npos);
}

TEST(ReportPdf, IsInJapaneseToo) {
  ReportInputs made = inputs();
  made.language = ReportLanguage::Japanese;
  const std::string pdf = reportPdf(made);
  expectWhole(pdf);
  EXPECT_NE(pdf.find("<8A2D5B9A> Tj"), std::string::npos) << "settings";
  EXPECT_EQ(pdf.find("(Settings)"), std::string::npos);
  // No line is wider than the page is between its margins; full stops do not begin one.
  const std::regex line(R"(Tf ([0-9.]+) [0-9.]+ Td <([0-9A-F]*)> Tj)");
  for (std::sregex_iterator at(pdf.begin(), pdf.end(), line), end; at != end; ++at) {
    const std::string hex = (*at)[2];
    double width_mm = std::stod((*at)[1]);
    for (std::size_t i = 0; i < hex.size(); i += 4) {
      width_mm += 3.2 * (hex.compare(i, 2, "00") == 0 ? 0.5 : 1.0);
    }
    EXPECT_LT(width_mm, 198.0) << hex;
    EXPECT_FALSE(hex.starts_with("3002") || hex.starts_with("3001")) << hex;
  }
}

TEST(ReportPdf, RefusesWhatIsNoReport) {
  ReportInputs made = inputs();
  made.run = "{}";
  EXPECT_THROW(reportPdf(made), Error);
}

}  // namespace
}  // namespace handmap
