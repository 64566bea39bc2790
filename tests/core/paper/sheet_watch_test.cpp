#include "core/paper/sheet_watch.h"

#include <gtest/gtest.h>

#include "core/paper/sheet_marks.h"
#include "core/paper/traced_map.h"
#include "tests/core/paper/photographed.h"

namespace handmap {
namespace {

const Polygon kFirst = {{20, 100}, {62, 100}, {62, 130}, {20, 130}};
const Polygon kSecond = {{150, 40}, {205, 40}, {205, 70}, {150, 70}};

/// A camera over the table, a little from the side, that sees so many images with noise.
class Table {
 public:
  SheetSight look(SheetWatch& watch, const cv::Mat& print, int images = 1) {
    SheetSight sight = SheetSight::None;
    for (int i = 0; i < images; ++i) {
      shot_.seed = ++seed_;
      sight = watch.look(test::photographed(print, shot_));
    }
    return sight;
  }

 private:
  test::Shot shot_{0.3, 1.0, 0.1, 0.0, 0.0, 3.0, 7};
  std::uint64_t seed_ = 0;
};

/// From the right, over the sheet as far as `tip`, millimetres.
cv::Mat withHand(const cv::Mat& print, const Vec2& tip) {
  cv::Mat covered = print.clone();
  const cv::Point2d from = test::onPrint(tip), to = test::onPrint({300.0, tip.y() - 60.0});
  cv::line(covered, from, to, {125, 160, 205}, 500, cv::LINE_AA);
  return covered;
}

TEST(SheetWatch, FollowsThePenAndAHandChangesNothing) {
  Table table;
  SheetWatch watch;
  cv::Mat print = test::printed(emptySheet(200.0));
  EXPECT_EQ(table.look(watch, print), SheetSight::Moving);  // nobody knows yet
  EXPECT_EQ(table.look(watch, print), SheetSight::Seen);
  EXPECT_TRUE(watch.trace().shapes.empty());
  test::penned(print, kFirst);
  EXPECT_EQ(table.look(watch, print, 3), SheetSight::Seen);
  ASSERT_EQ(watch.trace().shapes.size(), 1u);
  const Polygon before = watch.trace().shapes[0].outline;
  const int number = watch.numbers()[0];

  // Over what is drawn, over a mark, and off again.
  EXPECT_EQ(table.look(watch, withHand(print, {40.0, 110.0}), 4), SheetSight::Covered);
  EXPECT_EQ(table.look(watch, withHand(print, {200.0, 60.0}), 4), SheetSight::None);
  ASSERT_EQ(watch.trace().shapes.size(), 1u);
  test::penned(print, kSecond);
  table.look(watch, print, 4);
  ASSERT_EQ(watch.trace().shapes.size(), 2u);
  EXPECT_EQ(watch.numbers()[0], number);
  EXPECT_EQ(watch.trace().shapes[0].outline, before);
}

TEST(SheetWatch, WhatIsErasedGoesAndWhatIsChangedChanges) {
  Table table;
  SheetWatch watch;
  const cv::Mat bare = test::printed(emptySheet(200.0));
  cv::Mat both = bare.clone(), wider = bare.clone();
  for (const Polygon& house : {kFirst, kSecond}) test::penned(both, house);
  table.look(watch, both, 4);
  ASSERT_EQ(watch.trace().shapes.size(), 2u);
  const int number = watch.numbers()[0];
  test::penned(wider, {{20, 100}, {75, 100}, {75, 130}, {20, 130}});
  table.look(watch, wider, 4);
  ASSERT_EQ(watch.trace().shapes.size(), 1u);
  EXPECT_EQ(watch.numbers()[0], number);
  const Bounds bounds = boundsOf(watch.trace().shapes[0].outline);
  const double mm = kSheetWidth_mm / watch.trace().page.image.cols;
  EXPECT_NEAR(mm * (bounds.high.x() - bounds.low.x()), 55.0, 1.0);
}

TEST(SheetWatch, SeesNothingWhileItMoves) {
  SheetWatch watch;
  const cv::Mat print = test::printed(emptySheet(200.0));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(watch.look(test::photographed(print, {0.3, 1.0, 0.1 + 0.05 * i})),
              SheetSight::Moving);
  }
  EXPECT_EQ(watch.look(cv::Mat(600, 800, CV_8UC3, cv::Scalar::all(90))), SheetSight::None);
}

TEST(SheetWatch, WhatIsSettledIsTracedAgainOnlyWhereItLooksOtherwise) {
  Table table;
  SheetWatch watch;
  cv::Mat print = test::printed(emptySheet(200.0));
  test::penned(print, kFirst);
  table.look(watch, print, 4);
  ASSERT_EQ(watch.trace().shapes.size(), 1u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(table.look(watch, print), SheetSight::Seen);
    EXPECT_FALSE(watch.isNew()) << i;
  }
  test::penned(print, {{150, 40}, {158, 40}});  // a short stroke
  EXPECT_EQ(table.look(watch, print), SheetSight::Seen);
  EXPECT_TRUE(watch.isNew());
}

TEST(SheetWatch, AFingerOnTheCodeDoesNotShiftAMap) {
  Map map;
  map.buildings.emplace_back().shape = Rectangle{{20.0, 30.0}, 40.0, 20.0, 0.0};
  const Sheet sheet = sheetFor(map);
  const cv::Mat print = test::printed(sheet, &map);
  cv::Mat touched = print.clone();
  cv::circle(touched, test::onPrint(placeCellPlace(30)), 60, {30, 40, 60}, cv::FILLED, cv::LINE_AA);
  Table table;
  SheetWatch watch;
  EXPECT_EQ(table.look(watch, touched, 3), SheetSight::None);
  EXPECT_EQ(table.look(watch, print, 2), SheetSight::Seen);
  EXPECT_EQ(watch.trace().page.sheet, sheet.code);
  EXPECT_FALSE(isPlaceUnread(watch.trace()));
}

}  // namespace
}  // namespace handmap
