// Pages that are hard to read: hatched buildings, squares as dark as the pencil, a hand, a pen.
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/geometry/pose2.h"
#include "tests/core/paper/drawn_page.h"

namespace handmap {
namespace {

using test::page, test::sure;

const cv::Scalar kPencil(70, 70, 75);

void outlined(cv::Mat& on, const cv::Rect& box) {
  const std::vector<cv::Point> corners = {
      {box.x, box.y}, {box.br().x, box.y + 3}, {box.br().x - 2, box.br().y}, {box.x, box.br().y}};
  cv::polylines(on, corners, true, kPencil, 4, cv::LINE_AA);
}

/// Strokes across the box, from wall to wall and some a little further, as a hand does it.
void hatched(cv::Mat& on, const cv::Rect& box, double degrees, double apart_px,
             std::uint64_t seed) {
  cv::RNG random(seed);
  const cv::Point2d along(std::cos(toRadians(degrees)), std::sin(toRadians(degrees)));
  const cv::Point2d across(-along.y, along.x);
  const cv::Point2d middle = cv::Point2d(box.tl() + box.br()) * 0.5;
  for (double at = -1000.0; at < 1000.0; at += apart_px * random.uniform(0.8, 1.2)) {
    const double turn = random.uniform(-0.04, 0.04);
    const cv::Point2d way = along + turn * across;
    cv::Point from(middle + at * across - 2000.0 * way), to(middle + at * across + 2000.0 * way);
    const int beyond = random.uniform(-2, 4);
    const cv::Rect wall(box.x - beyond, box.y - beyond, box.width + 2 * beyond,
                        box.height + 2 * beyond);
    if (cv::clipLine(wall, from, to)) cv::line(on, from, to, kPencil, 3, cv::LINE_AA);
  }
}

/// Paper printed with squares of 5 mm as dark as `colour`.
cv::Mat squared(const cv::Scalar& colour) {
  cv::Mat on = page();
  for (int x = 11; x < on.cols; x += 27) cv::line(on, {x, 0}, {x, on.rows}, colour, 2, cv::LINE_AA);
  for (int y = 9; y < on.rows; y += 27) cv::line(on, {0, y}, {on.cols, y}, colour, 2, cv::LINE_AA);
  return on;
}

/// A finger or an arm: a rounded stick, lighter along its middle.
void limb(cv::Mat& on, const cv::Point& from, const cv::Point& to, int width,
          const cv::Scalar& colour) {
  for (int inner = width; inner > 2; inner -= 4)
    cv::line(on, from, to, colour * (1.15 - 0.35 * inner / width), inner, cv::LINE_AA);
}

/// A right hand from below that holds a pen to the page at `tip`, with its shadow.
void hand(cv::Mat& on, const cv::Point& tip) {
  const cv::Scalar skin(125, 160, 205);
  cv::Mat shadow = cv::Mat::zeros(on.size(), CV_8U);
  cv::line(shadow, tip + cv::Point(40, 90), tip + cv::Point(360, 900), 90, 260, cv::LINE_AA);
  cv::GaussianBlur(shadow, shadow, {}, 12.0);
  for (int y = 0; y < on.rows; ++y)
    for (int x = 0; x < on.cols; ++x)
      on.at<cv::Vec3b>(y, x) *= 1.0 - shadow.at<std::uint8_t>(y, x) / 255.0;
  limb(on, tip + cv::Point(190, 330), tip + cv::Point(420, 1100), 300, skin);
  limb(on, tip + cv::Point(30, 60), tip + cv::Point(120, 260), 80, skin);
  limb(on, tip + cv::Point(95, 75), tip + cv::Point(200, 260), 80, skin);
  limb(on, tip + cv::Point(190, 130), tip + cv::Point(260, 300), 85, skin);
  cv::line(on, tip, tip + cv::Point(-18, 14), {50, 40, 40}, 5, cv::LINE_AA);
  limb(on, tip + cv::Point(10, -10), tip + cv::Point(150, -330), 40, {160, 60, 30});
}

/// How many of the boxes are found, and what is taken for a building beside them.
std::pair<int, int> foundAndWrong(const cv::Mat& photo, const std::vector<cv::Rect>& boxes) {
  const Trace trace = traced(photo);
  const double scale = static_cast<double>(photo.cols) / trace.page.image.cols;
  std::vector<bool> found(boxes.size(), false);
  int wrong = 0;
  for (const TracedShape& shape : sure(trace)) {
    bool right = false;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const cv::Rect& box = boxes[i];
      Polygon outline = shape.outline;
      for (Vec2& p : outline) p *= scale;
      const Polygon there =
          Rectangle{{box.x + box.width / 2.0, photo.rows - box.y - box.height / 2.0},
                    static_cast<double>(box.width),
                    static_cast<double>(box.height),
                    0.0}
              .corners();
      if (intersectionOverUnion(outline, there) < 0.8) continue;
      right = true;
      found[i] = true;
    }
    wrong += !right;
  }
  return {static_cast<int>(std::ranges::count(found, true)), wrong};
}

const std::vector<cv::Rect> kHouses = {
    {150, 140, 260, 150}, {620, 170, 160, 240}, {1000, 150, 400, 180}, {180, 620, 200, 200}};

TEST(HardPages, HatchedBuildingsAreWhole) {
  for (const double apart_px : {9.0, 14.0, 20.0, 30.0}) {
    for (const double degrees : {45.0, -60.0, 20.0}) {
      cv::Mat drawing = page();
      for (std::size_t i = 0; i < kHouses.size(); ++i) {
        outlined(drawing, kHouses[i]);
        hatched(drawing, kHouses[i], degrees, apart_px, i + 1);
      }
      EXPECT_EQ(foundAndWrong(drawing, kHouses), std::pair(4, 0)) << apart_px << " " << degrees;
    }
  }
}

TEST(HardPages, CrossHatchedBuildingsAreWhole) {
  for (const double apart_px : {12.0, 22.0}) {
    cv::Mat drawing = page();
    for (std::size_t i = 0; i < kHouses.size(); ++i) {
      outlined(drawing, kHouses[i]);
      hatched(drawing, kHouses[i], 45.0, apart_px, i + 1);
      hatched(drawing, kHouses[i], -45.0, apart_px, i + 11);
    }
    EXPECT_EQ(foundAndWrong(drawing, kHouses), std::pair(4, 0)) << apart_px;
  }
}

TEST(HardPages, NeighboursHatchedEachWayAreTwo) {
  cv::Mat drawing = page();
  const std::vector<cv::Rect> houses = {{300, 300, 200, 200}, {500, 300, 220, 200}};
  for (std::size_t i = 0; i < 2; ++i) {
    outlined(drawing, houses[i]);
    hatched(drawing, houses[i], i == 0 ? 45.0 : -45.0, 16.0, i + 1);
  }
  EXPECT_EQ(foundAndWrong(drawing, houses), std::pair(2, 0));
}

TEST(HardPages, ATerraceOfNarrowHousesIsNoHatching) {
  cv::Mat drawing = page();
  std::vector<cv::Rect> houses;
  for (int i = 0; i < 6; ++i) houses.push_back({300 + 60 * i, 300, 60, 120});
  for (const cv::Rect& house : houses) outlined(drawing, house);
  EXPECT_EQ(foundAndWrong(drawing, houses), std::pair(6, 0));
}

TEST(HardPages, FilledBuildingsAreRead) {
  cv::Mat drawing = page();
  const std::vector<cv::Rect> houses = {
      {200, 200, 70, 45}, {600, 300, 40, 90}, {900, 250, 60, 60}, {400, 700, 100, 50}};
  for (const cv::Rect& house : houses) cv::rectangle(drawing, house, kPencil, cv::FILLED);
  cv::line(drawing, {100, 500}, {1500, 560}, kPencil, 4, cv::LINE_AA);  // a road
  EXPECT_EQ(foundAndWrong(drawing, houses), std::pair(4, 0));
}

TEST(HardPages, SquaresAsDarkAsThePencilAreNoBuildings) {
  cv::Mat drawing = squared(kPencil);
  for (const cv::Rect& house : kHouses) outlined(drawing, house);
  EXPECT_EQ(foundAndWrong(drawing, kHouses), std::pair(4, 0));
  EXPECT_EQ(foundAndWrong(squared(kPencil), {}), std::pair(0, 0));
}

TEST(HardPages, WhatIsDrawnAlongTheSquaresIsRead) {
  cv::Mat drawing = squared(kPencil);
  const std::vector<cv::Rect> houses = {{11 + 27 * 8, 9 + 27 * 6, 27 * 9, 27 * 5},
                                        {11 + 27 * 30, 9 + 27 * 20, 27 * 5, 27 * 10}};
  for (const cv::Rect& house : houses) cv::rectangle(drawing, house, kPencil, 6, cv::LINE_AA);
  EXPECT_EQ(foundAndWrong(drawing, houses), std::pair(2, 0));
}

TEST(HardPages, SquaresOfATiltedPhotoAreNoBuildings) {
  cv::Mat drawing = squared(kPencil);
  for (const cv::Rect& house : kHouses) outlined(drawing, house);
  const Quad from = {cv::Point2f{0, 0}, {1600, 0}, {1600, 1130}, {0, 1130}};
  const Quad seen = {cv::Point2f{320, 260}, {1640, 330}, {1830, 1340}, {130, 1200}};
  cv::Mat photo(1500, 2000, CV_8UC3, cv::Scalar(60, 70, 80));
  cv::warpPerspective(drawing, photo, cv::getPerspectiveTransform(from.data(), seen.data()),
                      photo.size(), cv::INTER_AREA, cv::BORDER_TRANSPARENT);
  EXPECT_EQ(sure(traced(photo)).size(), 4u);
}

TEST(HardPages, AHandIsNoBuilding) {
  cv::Mat drawing = page();
  for (const cv::Rect& house : kHouses) outlined(drawing, house);
  for (const cv::Point& tip : {cv::Point(700, 560), {1020, 330}, {1180, 430}}) {
    cv::Mat covered = drawing.clone();
    hand(covered, tip);
    const auto [found, wrong] = foundAndWrong(covered, kHouses);
    EXPECT_GE(found, 3) << tip;
    EXPECT_EQ(wrong, 0) << tip;
  }
}

TEST(HardPages, APenOnThePageIsNoBuilding) {
  cv::Mat drawing = page();
  for (const cv::Rect& house : kHouses) outlined(drawing, house);
  limb(drawing, {900, 500}, {1400, 900}, 45, {160, 60, 30});
  EXPECT_EQ(foundAndWrong(drawing, kHouses), std::pair(4, 0));
}

}  // namespace
}  // namespace handmap
