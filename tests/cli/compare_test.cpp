#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace handmap {
namespace {

using Compare = CliTest;

TEST_F(Compare, PrintsTheTables) {
  expectDone(run({"compare", "row-drawn.handmap", "row-truth.handmap"}),
             contentOf(std::filesystem::path(HANDMAP_CLI_EXPECTED) / "compare.txt"));
}

TEST_F(Compare, RestrictsThemToSomeBuildings) {
  expectDone(run({"compare", "--only", "N1", "row-truth.handmap", "row-truth.handmap"}),
             "As it is\n"
             "\n"
             "| building  |     x m | front m | width m |   IoU | overlaps |\n"
             "|:----------|--------:|--------:|--------:|------:|---------:|\n"
             "| N1        |   +0.00 |   +0.00 |   +0.00 |  1.00 |      yes |\n"
             "| mean of 1 |    0.00 |    0.00 |    0.00 |  1.00 |   1 of 1 |\n"
             "\n"
             "Aligned: moved by +0.00 m, +0.00 m, turned by +0.00 deg\n"
             "\n"
             "| building  |     x m | front m | width m |   IoU | overlaps |\n"
             "|:----------|--------:|--------:|--------:|------:|---------:|\n"
             "| N1        |   +0.00 |   +0.00 |   +0.00 |  1.00 |      yes |\n"
             "| mean of 1 |    0.00 |    0.00 |    0.00 |  1.00 |   1 of 1 |\n");
}

TEST_F(Compare, MeasuresTrajectories) {
  writeText("truth.tum", "0 0 0 0 0 0 0 1\n10 10 0 0 0 0 0 1\n");
  writeText("estimate.tum", "0 0 3 0 0 0 0 1\n5 5 3 0 0 0 0 1\n10 10 4 0 0 0 0 1\n");
  const Outcome outcome = run({"compare", "row-truth.handmap", "row-truth.handmap", "--trajectory",
                               "estimate.tum", "--truth", "truth.tum"});
  EXPECT_EQ(outcome.status, 0);
  const std::string table =
      "\nTrajectory: 3 poses, 10.0 m\n"
      "\n"
      "| rms m | max m | end m | heading rms deg | aligned rms m |\n"
      "|------:|------:|------:|----------------:|--------------:|\n"
      "|  3.37 |  4.00 |  4.00 |            0.00 |          0.24 |\n";
  ASSERT_GE(outcome.out.size(), table.size());
  EXPECT_EQ(outcome.out.substr(outcome.out.size() - table.size()), table);
}

TEST_F(Compare, SpeaksJson) {
  const Outcome outcome = run({"compare", "row-drawn.handmap", "row-truth.handmap", "--json"});
  EXPECT_EQ(outcome.status, 0);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["as_it_is"]["buildings"].size(), 2U);
  EXPECT_EQ(json["as_it_is"]["buildings"][0]["id"], "N1");
  EXPECT_NEAR(json["as_it_is"]["buildings"][0]["x"].get<double>(), 2.0, 1e-9);
  EXPECT_EQ(json["missing"], nlohmann::json::array({"N2"}));
  EXPECT_EQ(json["extra"], nlohmann::json::array({"X"}));
}

TEST_F(Compare, RefusesWhatHasNothingInCommon) {
  writeText("other.handmap", R"({"format": "handmap", "version": 1, "buildings": []})");
  expectFailed(run({"compare", "other.handmap", "row-truth.handmap"}), 2,
               "handmap-cli: error: other.handmap: buildings: found no id of row-truth.handmap, "
               "expected the same ids\n");
  writeText("early.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
  writeText("late.tum", "100 0 0 0 0 0 0 1\n101 1 0 0 0 0 0 1\n");
  expectFailed(run({"compare", "row-truth.handmap", "row-truth.handmap", "--trajectory",
                    "early.tum", "--truth", "late.tum"}),
               2,
               "handmap-cli: error: early.tum: found no time in common with late.tum, expected "
               "poses of the same drive\n");
}

}  // namespace
}  // namespace handmap
