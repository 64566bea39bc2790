#include "core/evaluation/comparison_report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace handmap {
namespace {

ComparisonReport report() {
  ComparisonReport result;
  result.as_it_is.buildings = {{"N1", 1.234, -0.001, -3.0, 0.5, true},
                               {"S1", -2.0, 4.0, 1.0, 0.0, false}};
  result.as_it_is.missing = {"N2"};
  result.as_it_is.extra = {"X"};
  result.aligned = result.as_it_is;
  result.aligned.alignment = {1.5, -0.25, toRadians(-2.0)};
  return result;
}

TEST(ComparisonReport, IsATableOfMarkdown) {
  const std::string table =
      "| building  |     x m | front m | width m |   IoU | overlaps |\n"
      "|:----------|--------:|--------:|--------:|------:|---------:|\n"
      "| N1        |   +1.23 |   +0.00 |   -3.00 |  0.50 |      yes |\n"
      "| S1        |   -2.00 |   +4.00 |   +1.00 |  0.00 |       no |\n"
      "| mean of 2 |    1.62 |    2.00 |    2.00 |  0.25 |   1 of 2 |\n";
  EXPECT_EQ(formatText(report()),
            "As it is\n\n" + table +
                "\nAligned: moved by +1.50 m, -0.25 m, turned by -2.00 deg\n\n" + table +
                "\nOnly in the truth: N2\n\nNot in the truth: X\n");
}

TEST(ComparisonReport, TellsOnlyWhatIsAskedFor) {
  ComparisonReport some = report();
  some.only = {"S1"};
  some.trajectory = TrajectoryError{10, 0.5, 1.0, 0.25, toRadians(1.5), 0.125, 99.96};
  const std::string text = formatText(some);
  EXPECT_EQ(text.find("N1"), std::string::npos);
  EXPECT_EQ(text.find("N2"), std::string::npos);
  EXPECT_NE(text.find("| mean of 1 |    2.00 |    4.00 |    1.00 |  0.00 |   0 of 1 |\n"),
            std::string::npos);
  EXPECT_NE(text.find("\nTrajectory: 10 poses, 100.0 m\n"), std::string::npos);
  EXPECT_NE(text.find("|  0.50 |  1.00 |  0.25 |            1.50 |          0.12 |\n"),
            std::string::npos);
}

TEST(ComparisonReport, IsJsonForPrograms) {
  ComparisonReport all = report();
  all.trajectory = TrajectoryError{10, 0.5, 1.0, 0.25, 0.1, 0.125, 99.96};
  const auto json = nlohmann::json::parse(formatJson(all));
  EXPECT_EQ(json["as_it_is"]["buildings"][0]["id"], "N1");
  EXPECT_EQ(json["as_it_is"]["buildings"][0]["x"], 1.234);
  EXPECT_EQ(json["as_it_is"]["mean"]["buildings"], 2);
  EXPECT_EQ(json["aligned"]["alignment"][0], 1.5);
  EXPECT_EQ(json["missing"][0], "N2");
  EXPECT_EQ(json["trajectory"]["end_m"], 0.25);
  EXPECT_FALSE(nlohmann::json::parse(formatJson(report())).contains("trajectory"));
}

}  // namespace
}  // namespace handmap
