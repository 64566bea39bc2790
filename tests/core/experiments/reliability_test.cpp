#include "core/experiments/reliability.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

RunStatements statements(const std::string& name, bool simulated, int so, int not_so,
                         double stated) {
  RunStatements made;
  made.name = name;
  made.simulated = simulated;
  for (int i = 0; i < so + not_so; ++i) {
    for (auto& of_distance : made.pose) of_distance.push_back({stated, i < so});
    made.walls.push_back({stated, i < so});
  }
  return made;
}

TEST(Reliability, TellsStatedAndTrueByRangeWithIntervals) {
  const Report report =
      reliabilityReport({statements("a", true, 9, 1, 0.9), statements("b", false, 5, 5, 0.92)});
  EXPECT_NE(report.csv.find("pose within 1 m,simulated,0.85,0.95,10,0.9000,0.9000,0.5958,0.9821\n"),
            std::string::npos)
      << report.csv;
  EXPECT_NE(report.csv.find("wall within its sigma,real,0.85,0.95,10,0.9200,0.5000,0.2366,0.7634"),
            std::string::npos)
      << report.csv;
  EXPECT_NE(report.markdown.find("| pose within 5 m | real | 85–95 % | 10 | 92 % | 50 % [24–76 %]"),
            std::string::npos)
      << report.markdown;
  EXPECT_NE(report.markdown.find("| b | wall within its sigma | 10 | 92 % | 50 %"),
            std::string::npos);
  ASSERT_EQ(report.charts.size(), 4U);
  EXPECT_EQ(report.charts[0].second.series.size(), 3U);  // as stated, simulated, real
}

TEST(Reliability, CertaintyIsInTheLastRange) {
  const Report report = reliabilityReport({statements("a", true, 4, 0, 1.0)});
  EXPECT_NE(report.csv.find("pose within 2 m,simulated,0.95,1,4,1.0000,1.0000,"), std::string::npos)
      << report.csv;
}

TEST(Reliability, ADriveStatesWithEachObservation) {
  TrialSettings settings;
  settings.seed = 21;
  const auto observed = observeTrial({Method::Handmap, 5.0, 0}, settings, {});
  ASSERT_TRUE(observed);
  EXPECT_TRUE(observed->simulated);
  EXPECT_GT(observed->pose[0].size(), 10U);
  EXPECT_EQ(observed->walls.size() % 4, 0U);
  EXPECT_GT(observed->walls.size(), 15U);
  for (std::size_t i = 0; i < observed->pose[0].size(); ++i) {
    EXPECT_LE(observed->pose[0][i].stated, observed->pose[1][i].stated);
    EXPECT_LE(observed->pose[1][i].stated, observed->pose[2][i].stated);
    EXPECT_LE(observed->pose[2][i].stated, 1.0);
    EXPECT_GT(observed->pose[2][i].stated, 0.0);
  }
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(observeTrial({Method::Handmap, 5.0, 0}, settings, stop.get_token()));
}

}  // namespace
}  // namespace handmap
