#include <QLabel>
#include <QSignalSpy>

#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "core/map/certainty.h"
#include "core/method/pose_trust.h"
#include "widgets/run/panels/change_series.h"
#include "widgets/run/panels/charts_panel.h"
#include "widgets/run/panels/frame_budget.h"
#include "widgets/run/panels/plot.h"

namespace handmap {
namespace {

std::vector<FrameReport> reports(std::size_t count) {
  std::vector<FrameReport> reports(count);
  for (std::size_t i = 0; i < count; ++i) {
    reports[i].frame = static_cast<int>(i);
    reports[i].time_s = 0.1 * static_cast<double>(i);
    reports[i].effective_sample_size = 50.0;
    reports[i].pose_sigma = {0.3, 0.4, 0.1};
    reports[i].ms.stereo = 5.0;
    reports[i].ms.slam = 15.0 + static_cast<double>(i % 100);
    reports[i].ms.total = reports[i].ms.stereo + reports[i].ms.slam;
  }
  return reports;
}

TEST(ChartsPanel, TakesAnyNumberOfReports) {
  ChartsPanel panel;
  panel.resize(300, 300);
  panel.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  QCoreApplication::processEvents();
  const QImage empty = panel.grab().toImage();
  panel.add(reports(5000));
  QTest::qWait(300);  // charts are drawn a few times a second
  const QImage full = panel.grab().toImage();
  EXPECT_NE(full, empty);
  panel.clear();
  QTest::qWait(300);
  EXPECT_NE(panel.grab().toImage(), full);
}

TEST(ChartsPanel, AClickAndTheKeysChooseAMoment) {
  ChartsPanel panel;
  panel.resize(400, 400);
  panel.add(reports(101));  // 10 s
  panel.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  auto* plot = panel.findChild<Plot*>();
  ASSERT_NE(plot, nullptr);
  std::vector<double> chosen;
  QObject::connect(&panel, &ChartsPanel::timeChosen, &panel,
                   [&chosen](double time_s) { chosen.push_back(time_s); });
  const QRectF area = plot->chart()->plotArea();
  const auto at = [&](double share) {
    return plot->mapFromScene(QPointF(area.left() + share * area.width(), area.center().y()));
  };
  QTest::mouseClick(plot->viewport(), Qt::LeftButton, {}, at(0.5));
  ASSERT_EQ(chosen.size(), 1U);
  EXPECT_NEAR(chosen[0], 5.0, 0.1);
  panel.setCursor(5.0);
  QTest::keyClick(plot, Qt::Key_Left);
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_NEAR(chosen[1], 4.9, 1e-9);
}

TEST(ChartsPanel, TheSampleSizeIsShownWhereItMeansSomething) {
  ChartsPanel panel;
  const auto shown = [&panel] {
    QStringList names;
    for (const Plot* plot : panel.findChildren<Plot*>()) {
      if (!plot->isHidden()) names << plot->accessibleName();
    }
    return names.filter("sample size").size();
  };
  EXPECT_EQ(shown(), 0);
  panel.showSampleSize(true);
  EXPECT_EQ(shown(), 1);
}

TEST(ReportSeries, KnowsHowSureAndHowFarOffThePoseIs) {
  ReportSeries series;
  for (const FrameReport& report : reports(10)) series.add(report, 0.7);
  series.add(reports(11).back());
  EXPECT_NEAR(series.points().front().spread_m, certainWithin(reports(1).front()), 1e-12);
  EXPECT_NEAR(series.points().front().error_m, 0.7, 1e-12);
  EXPECT_NEAR(series.points()[9].time_s, 0.9, 1e-12);
  EXPECT_TRUE(std::isnan(series.points().back().error_m));
}

TEST(FrameBudget, TellsSharesAndPercentilesAgainstTheInterval) {
  FrameBudget budget;
  EXPECT_FALSE(budget.intervalMs());
  EXPECT_EQ(budget.total().p95_ms, 0.0);
  for (const FrameReport& report : reports(1100)) budget.add(report);
  EXPECT_NEAR(budget.intervalMs().value(), 100.0, 1e-6);
  EXPECT_NEAR(budget.of(&StageTimes::stereo).share, 5.0 / 69.5, 1e-6);
  EXPECT_NEAR(budget.of(&StageTimes::stereo).p95_ms, 5.0, 1e-12);
  EXPECT_NEAR(budget.total().p50_ms, 70.0, 1.5);
  EXPECT_NEAR(budget.total().p95_ms, 115.0, 1.5);
}

Map rowOf(int count, double y) {
  Map map;
  for (int i = 0; i < count; ++i) {
    Building building;
    building.id = "N" + std::to_string(i);
    building.shape = Rectangle{{20.0 * i, y * i}, 10.0, 10.0, 0.0};
    map.buildings.push_back(building);
  }
  return map;
}

TEST(ChangeSeries, KeepsMomentsInOrderWhateverOrderTheyComeIn) {
  ChangeSeries series;
  series.setDrawing(rowOf(3, 0.0));
  series.setTruth(TrueMiddles(rowOf(3, 3.0)));
  series.add(2.0, rowOf(3, 2.0));
  series.add(1.0, rowOf(3, 1.0));
  series.add(2.0, rowOf(3, 2.5));  // looked at again
  ASSERT_EQ(series.moments().size(), 2U);
  EXPECT_EQ(series.moments().begin()->first, 1.0);
  EXPECT_FLOAT_EQ(series.moments().rbegin()->second.moved_m[2], 5.0F);
  EXPECT_NEAR(series.moments().rbegin()->second.mean_error_m.value(), 0.5, 1e-9);
  EXPECT_EQ(series.farthest(5), (std::vector<std::size_t>{2, 1})) << "the first has not moved";
  EXPECT_EQ(series.farthest(1).size(), 1U);
}

TEST(ChangeSeries, IsBoundedAndKeepsBothEnds) {
  ChangeSeries series;
  series.setDrawing(rowOf(2, 0.0));
  for (int i = 0; i <= 10'000; ++i) series.add(i, rowOf(2, 1e-3 * i));
  EXPECT_LE(series.moments().size(), ChangeSeries::kMostMoments + 1);
  EXPECT_GT(series.moments().size(), ChangeSeries::kMostMoments / 3);
  EXPECT_EQ(series.moments().begin()->first, 0.0);
  EXPECT_EQ(series.moments().rbegin()->first, 10'000.0);
}

}  // namespace
}  // namespace handmap
