#include "widgets/run/panels/report_series.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

FrameReport reportOf(int frame) {
  FrameReport report;
  report.frame = frame;
  report.effective_sample_size = 2.0 * frame;
  report.ms.slam = 3.0;
  report.ms.total = 4.0;
  return report;
}

TEST(ReportSeries, KeepsAShortRunAsItIs) {
  ReportSeries series;
  for (int frame = 0; frame < 100; ++frame) series.add(reportOf(frame));
  ASSERT_EQ(series.points().size(), 100U);
  EXPECT_EQ(series.points()[42].frame, 42.0);
  EXPECT_EQ(series.points()[42].effective_sample_size, 84.0);
}

TEST(ReportSeries, StaysBoundedAndCoversTheWholeOfALongRun) {
  ReportSeries series;
  constexpr int kFrames = 100'000;
  for (int frame = 0; frame < kFrames; ++frame) series.add(reportOf(frame));
  const auto& points = series.points();
  ASSERT_LT(points.size(), ReportSeries::kMostPoints);
  ASSERT_GE(points.size(), ReportSeries::kMostPoints / 4);
  EXPECT_LT(points.front().frame, kFrames * 0.01);
  EXPECT_GT(points.back().frame, kFrames * 0.99);
  for (const auto& point : points) {
    EXPECT_NEAR(point.effective_sample_size, 2.0 * point.frame, 1e-6);
    EXPECT_NEAR(point.ms.slam, 3.0, 1e-9);
    EXPECT_NEAR(point.ms.total, 4.0, 1e-9);
  }
}

TEST(ReportSeries, ForgetsEverything) {
  ReportSeries series;
  for (int frame = 0; frame < 10'000; ++frame) series.add(reportOf(frame));
  series.clear();
  series.add(reportOf(5));
  ASSERT_EQ(series.points().size(), 1U);
  EXPECT_EQ(series.points()[0].frame, 5.0);
}

}  // namespace
}  // namespace handmap
