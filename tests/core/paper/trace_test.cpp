#include "core/paper/trace.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/core/paper/drawn_page.h"

namespace handmap {
namespace {

using test::kPaper, test::page, test::sure;

const cv::Scalar kPen(60, 40, 30);

void stroke(cv::Mat& on, const std::vector<cv::Point>& points, const cv::Scalar& colour = kPen) {
  cv::polylines(on, points, false, colour, 4, cv::LINE_AA);
}

void house(cv::Mat& on, const cv::Rect& box, int gap = 0, const cv::Scalar& colour = kPen) {
  stroke(on,
         {{box.x + gap, box.y},
          {box.br().x, box.y + 3},
          {box.br().x - 2, box.br().y},
          {box.x, box.br().y - 3},
          {box.x, box.y}},
         colour);
}

double overlapWith(const TracedShape& shape, const cv::Rect& box, int rows) {
  const Polygon there = {{static_cast<double>(box.x), static_cast<double>(rows - box.br().y)},
                         {static_cast<double>(box.br().x), static_cast<double>(rows - box.br().y)},
                         {static_cast<double>(box.br().x), static_cast<double>(rows - box.y)},
                         {static_cast<double>(box.x), static_cast<double>(rows - box.y)}};
  return intersectionOverUnion(shape.outline, there);
}

TEST(Trace, FindsNothingOnABarePage) {
  EXPECT_TRUE(traced(page()).shapes.empty());
  for (const cv::Size size :
       {cv::Size(1, 1), cv::Size(2, 3), cv::Size(9000, 1), cv::Size(1, 9000)}) {
    const cv::Mat photo(size, CV_8UC3, kPaper);
    EXPECT_TRUE(traced(photo).shapes.empty());
    EXPECT_EQ(troubleWith(photo), "the photo has hardly a pixel");
  }
}

TEST(Trace, ClosesASmallGapAndSquaresWhatIsNearlySo) {
  cv::Mat drawing = page();
  const cv::Rect box(300, 300, 260, 180);
  house(drawing, box, 14);
  const auto shapes = sure(traced(drawing));
  ASSERT_EQ(shapes.size(), 1u);
  EXPECT_GT(overlapWith(shapes[0], box, drawing.rows), 0.95);
  EXPECT_EQ(shapes[0].outline.size(), 4u);
  EXPECT_FALSE(shapes[0].writing);
}

TEST(Trace, DividesATerraceAndKeepsTheWriting) {
  cv::Mat drawing = page();
  house(drawing, {300, 300, 400, 150});
  stroke(drawing, {{500, 301}, {498, 449}});
  cv::putText(drawing, "Post", {345, 390}, cv::FONT_HERSHEY_SIMPLEX, 1.2, kPen, 4);
  const auto shapes = sure(traced(drawing));
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_GT(overlapWith(shapes[0], {300, 300, 200, 150}, drawing.rows), 0.93);
  EXPECT_GT(overlapWith(shapes[1], {500, 300, 200, 150}, drawing.rows), 0.93);
  ASSERT_TRUE(shapes[0].writing);
  EXPECT_LT(std::abs(shapes[0].writing->x - 345), 12);
  EXPECT_FALSE(shapes[1].writing);
}

TEST(Trace, TakesNoRoadsNoBlocksAndNoFrame) {
  cv::Mat drawing = page();
  house(drawing, {60, 60, 1480, 1010});  // a frame
  house(drawing, {200, 200, 600, 500});  // a block with a house in it
  house(drawing, {300, 300, 150, 150});
  house(drawing, {900, 850, 600, 40});  // a road, closed at both ends
  const auto shapes = sure(traced(drawing));
  ASSERT_EQ(shapes.size(), 1u);
  EXPECT_GT(overlapWith(shapes[0], {300, 300, 150, 150}, drawing.rows), 0.9);
}

TEST(Trace, SeesThroughShadowsAndSquares) {
  cv::Mat drawing = page();
  for (int x = 40; x < 1600; x += 40) cv::line(drawing, {x, 0}, {x, 1130}, {225, 205, 185}, 1);
  for (int y = 40; y < 1130; y += 40) cv::line(drawing, {0, y}, {1600, y}, {225, 205, 185}, 1);
  house(drawing, {300, 300, 200, 150});
  house(drawing, {900, 500, 180, 260}, 0, {40, 40, 190});  // a red pen
  for (int x = 0; x < drawing.cols; ++x) {
    drawing.col(x) *= x < 700 ? 0.55 : 0.55 + 0.45 * std::min(1.0, (x - 700) / 60.0);
  }
  const auto shapes = sure(traced(drawing));
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_GT(overlapWith(shapes[0], {300, 300, 200, 150}, drawing.rows), 0.9);
  EXPECT_GT(overlapWith(shapes[1], {900, 500, 180, 260}, drawing.rows), 0.9);
}

TEST(Trace, ReadsChalkOnDarkPaper) {
  cv::Mat drawing(1130, 1600, CV_8UC3, cv::Scalar(35, 32, 30));
  for (int x = 60; x < 1600; x += 60) cv::line(drawing, {x, 0}, {x, 1130}, {80, 80, 80}, 1);
  house(drawing, {300, 300, 200, 150}, 0, {215, 215, 215});
  const Trace trace = traced(drawing);
  EXPECT_TRUE(trace.ink.dark_page);
  ASSERT_EQ(sure(trace).size(), 1u);
  EXPECT_GT(overlapWith(sure(trace)[0], {300, 300, 200, 150}, drawing.rows), 0.9);
}

TEST(Trace, StraightensAPageSeenFromTheSide) {
  cv::Mat drawing = page();
  const cv::Rect box(300, 300, 300, 200);
  house(drawing, box);
  const Quad from = {cv::Point2f{0, 0}, {1600, 0}, {1600, 1130}, {0, 1130}};
  const Quad seen = {cv::Point2f{520, 260}, {1540, 330}, {1830, 1240}, {180, 1100}};
  cv::Mat photo(1500, 2000, CV_8UC3, cv::Scalar(60, 70, 80));
  cv::warpPerspective(drawing, photo, cv::getPerspectiveTransform(from.data(), seen.data()),
                      photo.size(), cv::INTER_LINEAR, cv::BORDER_TRANSPARENT);
  const Trace trace = traced(photo);
  ASSERT_TRUE(trace.page.edges_found);
  ASSERT_EQ(sure(trace).size(), 1u);
  const Bounds bounds = boundsOf(sure(trace)[0].outline);
  EXPECT_NEAR(bounds.low.x() / trace.page.image.cols, 300.0 / 1600.0, 0.01);
  EXPECT_NEAR(bounds.high.x() / trace.page.image.cols, 600.0 / 1600.0, 0.01);
  EXPECT_NEAR(bounds.high.y() / trace.page.image.rows, 830.0 / 1130.0, 0.015);
}

TEST(Trace, SaysWhatIsWrongWithAPhoto) {
  EXPECT_EQ(troubleWith(cv::Mat(600, 800, CV_8UC3, cv::Scalar(9, 9, 9))), "the photo is dark");
  cv::Mat drawing = page();
  house(drawing, {300, 300, 260, 180});
  EXPECT_EQ(troubleWith(drawing), "");
  cv::GaussianBlur(drawing, drawing, {}, 25.0);
  EXPECT_EQ(troubleWith(drawing), "the photo is blurred, or there is no ink on it");
}

}  // namespace
}  // namespace handmap
