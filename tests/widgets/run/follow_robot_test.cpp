#include "widgets/run/overlays/follow_robot.h"

#include <QLabel>

#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "widgets/canvas/map_canvas.h"
#include "widgets/document/map_document.h"
#include "widgets/run/overlays/run_strip.h"

namespace handmap {
namespace {

class FollowRobotTest : public testing::Test {
 protected:
  FollowRobotTest() {
    canvas_.resize(400, 300);
    canvas_.zoomToRect({-20.0, -20.0, 40.0, 40.0});
  }
  QPointF middle() const {
    return canvas_.viewportTransform().inverted().map(
        canvas_.viewport()->rect().toRectF().center());
  }
  /// Where a point of the map is on the screen, from the middle; y up.
  QPointF onScreen(double x, double y) const {
    const QPointF at = canvas_.viewportTransform().map(QPointF(x, y)) -
                       canvas_.viewport()->rect().toRectF().center();
    return {at.x(), -at.y()};
  }

  MapDocument document_;
  MapCanvas canvas_{document_};
  FollowRobot follow_{canvas_};
};

TEST_F(FollowRobotTest, BringsTheRobotToTheMiddleWhenItLeavesTheView) {
  const QPointF before = middle();
  follow_.setPose({50.0, 10.0, 0.0});
  EXPECT_EQ(middle(), before) << "it is off at first";
  follow_.next();
  EXPECT_NEAR(middle().x(), 50.0, 0.2);
  follow_.setPose({-30.0, 90.0, 0.0});
  EXPECT_NEAR(middle().x(), -30.0, 0.2);
  EXPECT_NEAR(middle().y(), 90.0, 0.2);
  const QPointF here = middle();
  follow_.setPose({-29.0, 90.5, 0.0});
  EXPECT_EQ(middle(), here) << "what is well in sight does not move the map";
}

TEST_F(FollowRobotTest, TurnsTheMapSoThatTheRobotLooksUp) {
  const double scale = canvas_.pixelsPerMetre();
  follow_.setMode(FollowRobot::Mode::FollowAndTurn);
  for (const double heading : {0.0, 0.7, -2.0, kPi}) {
    follow_.setPose({50.0, 10.0, heading});
    const Vec2 ahead = Vec2(50.0, 10.0) + 10.0 * unitVector(heading);
    EXPECT_NEAR(onScreen(ahead.x(), ahead.y()).x(), 0.0, 2.0) << heading;
    EXPECT_NEAR(onScreen(ahead.x(), ahead.y()).y(), 10.0 * scale, 2.0) << heading;
    EXPECT_NEAR(canvas_.pixelsPerMetre(), scale, 1e-9);
  }
  follow_.next();
  EXPECT_EQ(follow_.mode(), FollowRobot::Mode::Off);
  EXPECT_EQ(canvas_.turn(), 0.0) << "one draws on an upright map";
}

TEST_F(FollowRobotTest, PanningByHandEndsIt) {
  follow_.setPose({5.0, 5.0, 1.0});
  follow_.setMode(FollowRobot::Mode::Follow);
  QTest::mousePress(canvas_.viewport(), Qt::MiddleButton, {}, {100, 100});
  QTest::mouseMove(canvas_.viewport(), {160, 100});
  QTest::mouseRelease(canvas_.viewport(), Qt::MiddleButton, {}, {160, 100});
  EXPECT_EQ(follow_.mode(), FollowRobot::Mode::Off);
  const QPointF here = middle();
  follow_.setPose({90.0, 5.0, 1.0});
  EXPECT_EQ(middle(), here);
}

TEST_F(FollowRobotTest, TheStripSaysWhereTheRobotIsAndWhetherTheViewFollows) {
  RunStrip strip(canvas_);
  EXPECT_TRUE(strip.isHidden());
  FrameReport report;
  report.pose_sigma = {0.2, 0.2, 0.01};
  strip.show(report, {});
  EXPECT_FALSE(strip.isHidden());
  EXPECT_TRUE(strip.words().contains("Sure to 0.4 m")) << strip.words().toStdString();
  EXPECT_EQ(strip.accessibleName(), strip.words());
  EXPECT_TRUE(canvas_.rect().contains(strip.geometry()));
  canvas_.show();
  canvas_.resize(500, 200);
  EXPECT_TRUE(canvas_.rect().contains(strip.geometry()));
  strip.showNothing();
  EXPECT_TRUE(strip.isHidden());
}

TEST_F(FollowRobotTest, TheStripIsAtOnceAsWideAsItsWords) {
  canvas_.resize(900, 300);
  canvas_.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas_));
  RunStrip strip(canvas_);
  FrameReport report;
  report.pose_sigma = {0.2, 0.2, 0.0};
  strip.show(report, {});
  QTest::qWait(20);
  report.pose_sigma = {12.0, 12.0, 0.3};
  report.pose = {-1234.0, -5678.0, 0.0};
  strip.show(report, {});
  for (const QLabel* label : strip.findChildren<QLabel*>()) {
    if (label->isHidden()) continue;
    EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
  }
}

}  // namespace
}  // namespace handmap
