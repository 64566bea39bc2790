#include "core/experiments/timing.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(Timing, HasThePapersSixCombinations) {
  const auto& combinations = publishedCombinations();
  ASSERT_EQ(combinations.size(), 6U);
  EXPECT_EQ(combinations[4].pso_particles, 20);
  EXPECT_EQ(combinations[4].slam_particles, 100);
  EXPECT_EQ(combinations[4].published_s, 106.0);
}

TEST(Timing, TellsMediansBesideThePublishedTimes) {
  const Combination combination{20, 100, 106.0};
  const Report report =
      timeReport({{Method::Paper, combination, {0.5, 0.1, 0.2}}, {Method::Handmap, {}, {0.01}}}, 1);
  EXPECT_EQ(report.csv,
            "method,pso_particles,slam_particles,frames,published_s,median_s,low_s,high_s,p95_s\n"
            "paper,20,100,3,106,0.200000,0.100000,0.500000,0.200000\n"
            "handmap,,,1,,0.010000,0.010000,0.010000,0.010000\n");
  EXPECT_NE(report.markdown.find(
                "| paper | 20 | 100 | 3 | 106 | 0.2000 [0.1000–0.5000] | 0.2000 | 530 |\n"),
            std::string::npos)
      << report.markdown;
  EXPECT_NE(report.markdown.find("Each run on 1 thread."), std::string::npos);
  ASSERT_EQ(report.charts.size(), 1U);
  EXPECT_EQ(report.charts[0].second.categories, (std::vector<std::string>{"20x100", "handmap"}));
}

}  // namespace
}  // namespace handmap
