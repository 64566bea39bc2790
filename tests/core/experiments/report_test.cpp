#include "core/experiments/report.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/core/experiments/made_trial.h"

namespace handmap {
namespace {

std::map<TrialKey, Trial> trials(double sigma_m, Method method, const std::vector<double>& ious) {
  std::map<TrialKey, Trial> made;
  for (std::size_t i = 0; i < ious.size(); ++i) {
    const TrialKey key{method, sigma_m, static_cast<int>(i)};
    made.emplace(key, test::madeTrial(key, ious[i], 3 + i));
  }
  return made;
}

Experiment experiment(ExperimentKind kind, int count) {
  Experiment wanted;
  wanted.kind = kind;
  wanted.sigmas_m = {5.0};
  wanted.trials = count;
  return wanted;
}

bool contains(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// Around the pixels that have the colour of the handmap series.
cv::Rect blueArea(const cv::Mat& picture) {
  cv::Mat mask;
  cv::inRange(picture(cv::Rect(0, 90, picture.cols, picture.rows - 90)), cv::Scalar(178, 114, 0),
              cv::Scalar(178, 114, 0), mask);
  std::vector<cv::Point> pixels;
  cv::findNonZero(mask, pixels);
  return cv::boundingRect(pixels);
}

TEST(Report, CountsLooseAndStrictSuccess) {
  auto all = trials(5.0, Method::Handmap, {0.9, 0.5, 0.4, 0.0});
  all.merge(trials(5.0, Method::Paper, {0.0, 0.0, 0.3, 0.0}));
  all.at({Method::Handmap, 5.0, 0}).buildings[4].iou = 0.2;  // one building is enough
  const Report report = reportOf(experiment(ExperimentKind::Table2, 4), all);
  EXPECT_EQ(report.csv,
            "sigma_m,method,trials,loose,loose_low,loose_high,strict,strict_low,strict_high\n"
            "5,handmap,4,3,0.3006,0.9544,1,0.0456,0.6994\n"
            "5,paper,4,1,0.0456,0.6994,0,0.0000,0.4899\n");
  EXPECT_TRUE(contains(report.markdown, "| 5 | handmap | 4 | 3 [30–95 %] | 1 [5–70 %] |  |  |\n"));
  EXPECT_TRUE(
      contains(report.markdown, "| 5 | paper | 4 | 1 [5–70 %] | 0 [0–49 %] | 5/5 | 10/10 |\n"));
  EXPECT_FALSE(contains(report.markdown, "Not whole"));
}

TEST(Report, SaysWhatIsMissing) {
  const auto some = trials(5.0, Method::Handmap, {0.9, 0.9});
  for (const ExperimentKind kind :
       {ExperimentKind::Table2, ExperimentKind::Figure8, ExperimentKind::Way}) {
    const Report report = reportOf(experiment(kind, 3), some);
    EXPECT_TRUE(contains(report.markdown, "**Not whole: 2 of 6 trials are there.**"));
    EXPECT_FALSE(report.charts.empty());
    for (const auto& [name, chart] : report.charts) {  // what is there is shown
      EXPECT_FALSE(blueArea(drawn(chart)).empty()) << name;
    }
  }
  // Trials that were not asked for are left out.
  const Report one = reportOf(experiment(ExperimentKind::Table2, 1), some);
  EXPECT_TRUE(contains(one.csv, "5,handmap,1,1,"));
}

TEST(Report, TellsAbsoluteErrorsBeforeAndAfter) {
  auto all = trials(5.0, Method::Handmap, {0.9, 0.9, 0.9});
  all.at({Method::Handmap, 5.0, 2}).buildings[0].found[0] = -3.5;
  const Report report = reportOf(experiment(ExperimentKind::Figure8, 3), all);
  EXPECT_TRUE(contains(report.csv, "5,handmap,N1,x,3,5.0000,5.0000,1.5000,0.5000,0.5000,3.5000\n"));
  EXPECT_TRUE(contains(
      report.markdown,
      "| N1 | handmap | 5.00 / 5.00 → 1.50 / 0.50 | 10.00 / 10.00 → 1.00 / 1.00 | 15.00 / 15.00 → "
      "1.50 / 1.50 |\n"));
  EXPECT_TRUE(contains(report.csv, "5,handmap,all,x,3,5.0000,5.0000,0.6667,0.5000,"));
  EXPECT_EQ(report.charts.front().first, "fig8-x-5m.png");
  const auto& [name, against_sigma] = report.charts[3];
  EXPECT_EQ(name, "fig8-x.png");
  ASSERT_EQ(against_sigma.series.size(), 2U);  // nothing of the paper's method is there
  EXPECT_NEAR(against_sigma.series[1].points.at(0).y.value, 0.6667, 1e-4);
}

TEST(Report, FollowsTheErrorsAsFarAsAllTrialsGo) {
  const auto all = trials(5.0, Method::Handmap, {0.9, 0.9});  // ways of 3 and 4 steps
  const Report report = reportOf(experiment(ExperimentKind::Way, 2), all);
  EXPECT_EQ(report.csv,
            "sigma_m,method,trials,way_m,pose,pose_low,pose_high,odometry,odometry_low,"
            "odometry_high,map,map_low,map_high\n"
            "5,handmap,2,0,0.0000,0.0000,0.0000,0.0000,0.0000,0.0000,5.0000,5.0000,5.0000\n"
            "5,handmap,2,5,0.1000,0.1000,0.1000,0.5000,0.5000,0.5000,4.7500,4.7500,4.7500\n"
            "5,handmap,2,10,0.2000,0.2000,0.2000,1.0000,1.0000,1.0000,4.5000,4.5000,4.5000\n");
}

TEST(Chart, StepsAreRound) {
  EXPECT_DOUBLE_EQ(tickStep(100.0), 20.0);
  EXPECT_DOUBLE_EQ(tickStep(15.75), 2.0);
  EXPECT_DOUBLE_EQ(tickStep(0.7), 0.1);
  EXPECT_DOUBLE_EQ(tickStep(0.0), 1.0);
  for (double most = 1e-3; most < 1e6; most *= 1.37) {
    EXPECT_GE(most / tickStep(most), 5.0 - 1e-9);
    EXPECT_LT(most / tickStep(most), 12.5);
  }
}

TEST(Chart, BarsSpanTheirIntervals) {
  Chart chart;
  chart.y_max = 100.0;
  chart.categories = {"A", "B"};
  chart.series = {{"handmap", SeriesLook::Handmap, {{0.0, {50.0, 25.0, 75.0}}}}};
  const cv::Rect bar = blueArea(drawn(chart));
  const cv::Size size = drawn(chart).size();
  const double plot = size.height - 170.0;
  EXPECT_NEAR(bar.y, 0.25 * plot, 3.0);
  EXPECT_NEAR(bar.height, 0.5 * plot, 6.0);
  EXPECT_NEAR(bar.x + bar.width / 2.0, 90.0 + (size.width - 130.0) / 4.0, 3.0);
}

TEST(Chart, DrawsNothingButTheFrameWithoutSeries) {
  Chart chart;
  chart.kind = Chart::Kind::Band;
  EXPECT_TRUE(blueArea(drawn(chart)).empty());
  EXPECT_LT(cv::mean(drawn(chart))[0], 255.0);
}

}  // namespace
}  // namespace handmap
