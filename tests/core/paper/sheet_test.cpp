#include "core/paper/sheet.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/paper/handwriting.h"
#include "core/paper/sheet_marks.h"
#include "core/paper/traced_map.h"
#include "tests/core/paper/photographed.h"

namespace handmap {
namespace {

/// Of buildings on the sheet, millimetres.
const std::vector<Polygon> kDrawn = {{{20, 100}, {62, 100}, {62, 130}, {20, 130}},
                                     {{150, 110}, {220, 110}, {220, 128}, {150, 128}},
                                     {{30, 35}, {75, 35}, {75, 58}, {52, 58}, {52, 76}, {30, 76}},
                                     {{160, 40}, {205, 52}, {197, 82}, {152, 70}}};

cv::Mat drawnOn(const Sheet& sheet) {
  cv::Mat print = test::printed(sheet);
  for (const Polygon& outline : kDrawn) test::penned(print, outline);
  return print;
}

/// Of the true corners to the nearest traced ones, the largest distance, millimetres; nothing where
/// a building is missing.
std::optional<double> worstCorner(const Trace& trace) {
  const double mm = kSheetWidth_mm / trace.page.image.cols;
  double worst = 0.0;
  for (const Polygon& drawn : kDrawn) {
    const TracedShape* found = nullptr;
    for (const TracedShape& shape : trace.shapes) {
      Polygon outline = shape.outline;
      for (Vec2& corner : outline) corner *= mm;
      if (shape.confidence >= kSureOfShape && intersectionOverUnion(outline, drawn) > 0.7)
        found = &shape;
    }
    if (!found) return std::nullopt;
    for (const Vec2& corner : drawn) {
      double nearest = 1e9;
      for (const Vec2& there : found->outline)
        nearest = std::min(nearest, (mm * there - corner).norm());
      worst = std::max(worst, nearest);
    }
  }
  return worst;
}

TEST(Sheet, TellsItselfByItsCode) {
  for (const double square_m : kSquares_m) {
    for (const bool of_map : {false, true}) {
      const SheetCode code{square_m, of_map};
      EXPECT_EQ(codeOf(codeCells(code)), code);
      auto wrong = codeCells(code);
      wrong[2] = !wrong[2];
      EXPECT_EQ(codeOf(wrong), std::nullopt);
    }
  }
}

TEST(Sheet, TellsWhereAMapIsPrinted) {
  EXPECT_EQ(cornerOf({}), std::nullopt);
  for (const std::array<int, 2>& corner :
       {std::array{0, 0}, std::array{-7, 300}, std::array{kMostCornerSteps, -kMostCornerSteps}}) {
    const auto cells = placeCells({10.0, true, corner});
    EXPECT_EQ(cornerOf(cells), corner);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      auto wrong = cells;
      wrong[i] = !wrong[i];
      EXPECT_EQ(cornerOf(wrong), std::nullopt);
    }
  }
}

TEST(Sheet, OfAMapDoesNotShiftWhenThatIsChanged) {
  Map map;
  Building house;
  house.id = "A";
  house.name = "Library";
  house.shape = Rectangle{{1003.7, -420.3}, 60.0, 30.0, 0.2};
  map.buildings = {house};
  const Sheet sheet = sheetFor(map);
  ASSERT_TRUE(sheet.code.corner);
  for (int i = 0; i < 8; ++i) {
    test::Shot shot{toRadians(45.0 * i / 7.0),
                    2.4 * i,
                    kPi / 2.0 * (i % 4),
                    0.1 * (i % 6),
                    0.5 * (i % 4),
                    static_cast<double>(i % 5),
                    static_cast<std::uint64_t>(i)};
    const Trace trace = traced(test::photographed(test::printed(sheet, &map), shot));
    EXPECT_TRUE(trace.shapes.empty()) << i;
    ASSERT_TRUE(trace.page.sheet) << i;
    EXPECT_EQ(*trace.page.sheet, sheet.code) << i;
    EXPECT_LT((sheetOf(*trace.page.sheet)->corner - sheet.corner).norm(), 1e-9);
  }
}

TEST(Sheet, IsTheOneThatTheMapWasDrawnOn) {
  const Sheet sheet = emptySheet(200.0);
  const Trace trace = traced(test::photographed(drawnOn(sheet), {}));
  Map map = mapOf(trace, placeOf(trace.page, sheet));
  EXPECT_THROW(overprintPdf(map), Error);
  map.underlays = {underlayOf(trace.page, placeOf(trace.page, sheet), "page.png")};
  map = parseMap(formatMap(map), "map");
  const Sheet again = sheetFor(map);
  EXPECT_LT((again.corner - sheet.corner).norm(), 1e-6);
  EXPECT_EQ(again.code.square_m, sheet.code.square_m);
  EXPECT_TRUE(overprintPdf(map).starts_with("%PDF-1.4\n"));
  map.buildings[0].shape = Rectangle{{400.0, 0.0}, 60.0, 30.0, 0.0};  // beyond it
  EXPECT_EQ(sheetFor(map).code.square_m, 50.0);
}

TEST(Sheet, IsTheOneThatTheMapWasDrawnOnWhateverThePhotoMeasures) {
  const Sheet sheet = emptySheet(200.0);
  const cv::Mat print = drawnOn(sheet);
  for (const int width : {1200, 1301, 1402, 1503}) {
    cv::Mat photo;
    cv::resize(print, photo, {width, width * print.rows / print.cols}, 0, 0, cv::INTER_AREA);
    const Trace trace = traced(photo);
    ASSERT_TRUE(trace.page.sheet) << width;
    const PagePlace place = placeOf(trace.page, sheet);
    Map map = mapOf(trace, place);
    map.underlays = {underlayOf(trace.page, place, "page.png")};
    EXPECT_TRUE(sheetUnder(map)) << width << ": " << trace.page.image.size();
  }
}

TEST(Sheet, IsAsLargeAsThePlaceNeeds) {
  EXPECT_EQ(emptySheet(24.0).code.square_m, 1.0);
  EXPECT_EQ(emptySheet(200.0).code.square_m, 10.0);
  EXPECT_EQ(emptySheet(4800.0).code.square_m, 200.0);
  EXPECT_THROW(emptySheet(4801.0), Error);
  const Sheet sheet = emptySheet(200.0);
  EXPECT_EQ(sheet.toMap({120.0, 20.0}), Vec2(0.0, 0.0));
  EXPECT_EQ(sheet.toPaper({10.0, 0.0}), Vec2(130.0, 20.0));
}

TEST(Sheet, HoldsAllOfAMap) {
  Map map;
  Building house;
  house.shape = Rectangle{{100.0, 50.0}, 300.0, 20.0, 0.0};
  map.buildings = {house};
  map.start = Pose2{90.0, 10.0, 0.0};
  const Sheet sheet = sheetFor(map);
  EXPECT_TRUE(sheet.code.of_map);
  EXPECT_EQ(sheet.code.square_m, 20.0);
  for (const Vec2& corner : house.footprint()) {
    const Vec2 there = sheet.toPaper(corner);
    EXPECT_TRUE(there.x() >= 0.0 && there.x() <= kSheetWidth_mm) << there.transpose();
    EXPECT_TRUE(there.y() >= 0.0 && there.y() <= kSheetHeight_mm) << there.transpose();
  }
}

TEST(Sheet, IsAPageOfPdf) {
  const std::string pdf = sheetPdf(emptySheet(200.0));
  EXPECT_TRUE(pdf.starts_with("%PDF-1.4\n"));
  EXPECT_NE(pdf.find("(50 m) Tj"), std::string::npos);
  const std::size_t at = pdf.rfind("startxref\n");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(pdf.compare(std::stoul(pdf.substr(at + 10)), 5, "xref\n"), 0);
}

TEST(Sheet, IsReadFromTwentyPhotos) {
  const Sheet sheet = emptySheet(200.0);
  const cv::Mat print = drawnOn(sheet);
  double worst = 0.0;
  for (int i = 0; i < 20; ++i) {
    test::Shot shot;
    shot.tilt = toRadians(45.0 * i / 19.0);
    shot.azimuth = 2.4 * i;
    shot.roll = kPi / 2.0 * (i % 4) + 0.1 * (i % 3);
    shot.shadow = 0.1 * (i % 6);
    shot.crumple_mm = 0.5 * (i % 4);
    shot.noise = i % 5;
    shot.seed = static_cast<std::uint64_t>(i);
    const Trace trace = traced(test::photographed(print, shot));
    ASSERT_TRUE(trace.page.sheet) << i;
    EXPECT_EQ(*trace.page.sheet, sheet.code) << i;
    const auto off = worstCorner(trace);
    ASSERT_TRUE(off) << i;
    EXPECT_LT(*off, 0.01 * kSheetWidth_mm) << i;
    worst = std::max(worst, *off);
  }
  RecordProperty("worst_mm", std::to_string(worst));
}

TEST(Sheet, IsNotOnAPhotoOfAFewPixels) {
  cv::Mat photo(6, 6, CV_8UC3, cv::Scalar::all(240));
  photo(cv::Rect(1, 1, 3, 3)) = cv::Scalar::all(0);
  EXPECT_FALSE(sheetOn(photo));
}

TEST(Sheet, IsNoBuildingItself) {
  Map map;
  Building house;
  house.id = "A";
  house.name = "Library";
  house.shape = Rectangle{{0.0, 20.0}, 60.0, 30.0, 0.2};
  map.buildings = {house};
  map.start = Pose2{0.0, -20.0, 0.0};
  const Sheet sheet = sheetFor(map);
  cv::Mat print = test::printed(sheet, &map);
  EXPECT_TRUE(traced(test::photographed(print, {})).shapes.empty());
  const Polygon drawn = Rectangle{{40.0, 30.0}, 40.0, 25.0, 0.0}.corners();
  test::penned(print, drawn);
  const Trace trace = traced(test::photographed(print, {}));
  ASSERT_EQ(trace.shapes.size(), 1u);
  ASSERT_TRUE(trace.page.sheet);
  EXPECT_TRUE(trace.page.sheet->of_map);
}

TEST(TracedMap, OfASheetIsInMetresAndSaysWhatItIsOffBy) {
  const Sheet sheet = emptySheet(200.0);
  const Trace trace = traced(test::photographed(drawnOn(sheet), {}));
  ASSERT_TRUE(trace.page.sheet);
  const PagePlace place = placeOf(trace.page, emptySheet(*trace.page.sheet));
  const Map map = mapOf(trace, place);
  ASSERT_EQ(map.buildings.size(), 4u);
  EXPECT_EQ(map.buildings[0].id, "B1");
  for (const Polygon& drawn : kDrawn) {
    Polygon there = drawn;
    for (Vec2& corner : there) corner = sheet.toMap(corner);
    EXPECT_TRUE(std::ranges::any_of(map.buildings, [&](const Building& building) {
      return intersectionOverUnion(building.footprint(), there) > 0.9;
    }));
  }
  EXPECT_GT(map.uncertainty.position, 10.0);
  EXPECT_GT(map.uncertainty.size, 5.0);
  const Underlay page = underlayOf(trace.page, place, "page.png");
  EXPECT_NEAR(page.x, -120.0, 0.5);
  EXPECT_NEAR(page.y, 140.0, 0.5);
}

TEST(TracedMap, IsAsWideAsOneSays) {
  cv::Mat page(1000, 1600, CV_8UC3, cv::Scalar::all(235));
  cv::rectangle(page, {200, 200, 200, 150}, {40, 40, 40}, 4);
  cv::rectangle(page, {1000, 500, 200, 150}, {40, 40, 40}, 4);
  const Trace trace = traced(page);
  const Map map = mapOf(trace, placeOfDrawing(trace, sureShapes(trace), 100.0));
  ASSERT_EQ(map.buildings.size(), 2u);
  const double left = boundsOf(map.buildings[0].footprint()).low.x();
  EXPECT_NEAR(boundsOf(map.buildings[1].footprint()).high.x() - left, 100.0, 0.5);
  EXPECT_NEAR(placeOfPage(trace.page, 160.0).metres_per_pixel, 0.1, 1e-3);
}

TEST(TracedMap, DrawnOverAMapChangesWhatIsUnderItAndAddsTheRest) {
  Map printed, drawn;
  Building house;
  house.id = "B1";
  house.name = "Library";
  house.shape = Rectangle{{0.0, 0.0}, 20.0, 10.0, 0.0};
  printed.buildings = {house};
  house.name.clear();
  house.shape = Rectangle{{1.0, 0.0}, 22.0, 10.0, 0.0};
  drawn.buildings = {house};
  house.shape = Rectangle{{50.0, 0.0}, 20.0, 10.0, 0.0};
  drawn.buildings.push_back(house);
  const Map both = drawnOver(printed, drawn);
  ASSERT_EQ(both.buildings.size(), 2u);
  EXPECT_EQ(both.buildings[0].name, "Library");
  EXPECT_EQ(both.buildings[0].shape, drawn.buildings[0].shape);
  EXPECT_EQ(both.buildings[1].id, "B2");
}

TEST(Handwriting, IsKeptInTheMapAndReadAgain) {
  Ink ink;
  ink.mask = cv::Mat::zeros(200, 600, CV_8U);
  cv::putText(ink.mask, "Library", {20, 120}, cv::FONT_HERSHEY_SIMPLEX, 3.0, 255, 8);
  TracedShape shape;
  shape.outline = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  shape.writing = cv::Rect(10, 30, 480, 120);
  Map map;
  map.buildings = {buildingOf(shape, ink, {})};
  map.buildings[0].id = "B1";
  const Map again = parseMap(formatMap(map), "map");
  const cv::Mat writing = writingOf(again.buildings[0]);
  ASSERT_EQ(writing.size(), cv::Size(192, 48));
  cv::Mat larger;
  cv::resize(writing, larger, shape.writing->size(), 0, 0, cv::INTER_LINEAR);
  const cv::Mat differs = (larger > 127) != ink.mask(*shape.writing);
  EXPECT_LT(cv::countNonZero(differs), 0.25 * cv::countNonZero(ink.mask));
}

TEST(Handwriting, InOtherWordsIsNone) {
  Building building;
  for (const char* other : {"[2,2]", "[2,2,3]", "[2,2,5]", "[2,2,-1,5]", "[2,2,\"x\",4]", "{}",
                            "[99999999999,1,1]", "[0,0,0]"}) {
    building.unknown[kWritingKey] = other;
    EXPECT_TRUE(writingOf(building).empty()) << other;
  }
  building.unknown[kWritingKey] = "[2,2,1,2,1]";
  EXPECT_EQ(cv::countNonZero(writingOf(building)), 2);
}

}  // namespace
}  // namespace handmap
