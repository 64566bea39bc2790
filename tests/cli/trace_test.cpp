// From a photo of a drawing on paper to a map, and on to a corrected one.
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/map/map_io.h"
#include "core/simulation/world.h"
#include "tests/cli/program.h"
#include "tests/core/paper/photographed.h"

namespace handmap {
namespace {

class TraceCommand : public CliTest {
 protected:
  /// Two houses, drawn with a pen on a page that fills the photo.
  static void drawTwoHouses() {
    cv::Mat page(900, 1400, CV_8UC3, cv::Scalar::all(235));
    cv::rectangle(page, {200, 200, 200, 150}, {40, 40, 40}, 4);
    cv::rectangle(page, {1000, 500, 200, 150}, {40, 40, 40}, 4);
    cv::imwrite("photo.png", page);
  }
};

TEST_F(TraceCommand, MakesADrawingThatKeepsThePage) {
  drawTwoHouses();
  expectDone(run({"trace", "photo.png", "--width", "100", "--out", "drawing.handmap"}),
             "drawing.handmap: 2 closed shapes taken for buildings, 0 left out\n"
             "drawing.handmap: the start is not known yet\n");
  EXPECT_EQ(contentOf("drawing.handmap"),
            contentOf(std::filesystem::path(HANDMAP_CLI_EXPECTED) / "traced.handmap"));
  EXPECT_FALSE(cv::imread("drawing-paper.png").empty());
  EXPECT_EQ(run({"validate", "drawing.handmap"}).out, "ok: drawing.handmap: map of 2 buildings\n");
}

TEST_F(TraceCommand, SaysWhatIsMissing) {
  drawTwoHouses();
  expectFailed(run({"trace", "photo.png", "--out", "drawing.handmap"}), 1,
               "handmap-cli: error: --width is required: this is no printed sheet, so that nothing "
               "tells the scale\nhint: handmap-cli trace --help\n");
  cv::imwrite("bare.png", cv::Mat(600, 800, CV_8UC3, cv::Scalar::all(235)));
  expectFailed(run({"trace", "bare.png", "--width", "100", "--out", "drawing.handmap"}), 2,
               "handmap-cli: error: bare.png: found no closed shapes: the photo is blurred, or "
               "there is no ink on it, expected outlines of buildings, drawn closed with a pen\n");
  writeText("other.png", "GIF89a");
  expectFailed(run({"trace", "other.png", "--width", "100", "--out", "drawing.handmap"}), 2,
               "handmap-cli: error: other.png: found no image, expected a PNG or JPEG image\n");
  EXPECT_FALSE(std::filesystem::exists("drawing.handmap"));
  EXPECT_FALSE(std::filesystem::exists("drawing-paper.png"));
}

TEST_F(TraceCommand, PrintsASheet) {
  expectDone(run({"sheet", "--width", "300", "--out", "sheet.pdf"}), "");
  EXPECT_EQ(contentOf("sheet.pdf"), sheetPdf(emptySheet(300.0)));
  expectDone(run({"sheet", "--map", "row-truth.handmap", "--out", "sheet.pdf"}), "");
  const Map map = readMap("row-truth.handmap");
  EXPECT_EQ(contentOf("sheet.pdf"), sheetPdf(sheetFor(map), &map));
}

TEST_F(TraceCommand, KnowsASheetThatAMapWasPrintedOn) {
  const Map map = readMap("row-truth.handmap");
  const Sheet sheet = sheetFor(map);
  cv::Mat print = test::printed(sheet, &map);
  const Vec2 beside = map.buildings[0].box().centre + Vec2(0.0, 3.0);
  Rectangle wider = map.buildings[0].box();
  wider.centre = beside;
  Polygon outline = wider.corners();
  for (Vec2& corner : outline) corner = sheet.toPaper(corner);
  test::penned(print, outline);
  cv::imwrite("photo.png", test::photographed(print, {0.3, 1.0, 2.0, 0.2, 0.5, 2.0, 3}));
  expectFailed(run({"trace", "photo.png", "--out", "drawing.handmap"}), 1,
               "handmap-cli: error: a map is printed on this sheet: --on is required\n"
               "hint: handmap-cli trace --help\n");
  expectDone(run({"trace", "photo.png", "--on", "row-truth.handmap", "--out", "drawing.handmap"}),
             "drawing.handmap: 1 closed shapes taken for buildings, 0 left out\n");
  const Map drawn = readMap("drawing.handmap");
  ASSERT_EQ(drawn.buildings.size(), map.buildings.size());
  EXPECT_EQ(drawn.start, map.start);
  EXPECT_NEAR(drawn.buildings[0].box().centre.y(), beside.y(), 0.5);
  EXPECT_EQ(drawn.buildings[1], map.buildings[1]);
}

/// Two rows of houses, the robot between them looking up the sheet.
void writePlace(const std::string& path) {
  Map place = twoRowWorld(3).map;
  const Pose2 quarter{0.0, 0.0, kPi / 2.0};
  for (Building& building : place.buildings) {
    Rectangle box = building.box();
    box.centre = quarter.toOuter(box.centre);
    box.heading += quarter.heading;
    building.shape = box;
  }
  for (Vec2& point : place.route) point = quarter.toOuter(point);
  place.start = quarter * *place.start;
  writeMap(place, path);
}

/// With a hand that shakes.
void drawOn(cv::Mat& print, const Sheet& sheet, const Map& remembered) {
  cv::RNG random(5);
  for (const Building& building : remembered.buildings) {
    Polygon stroke;
    const Polygon outline = building.footprint();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 side = outline[(i + 1) % outline.size()] - outline[i];
      for (int k = 0; k < 8; ++k) {
        stroke.push_back(sheet.toPaper(outline[i] + k / 8.0 * side) +
                         Vec2(random.gaussian(0.2), random.gaussian(0.2)));
      }
    }
    test::penned(print, stroke);
  }
}

double overlapOf(const std::string& map) {
  double sum = 0.0;
  const Map truth = readMap("place/truth.handmap"), drawn = readMap(map);
  for (const Building& building : truth.buildings) {
    double best = 0.0;
    for (const Building& other : drawn.buildings)
      best = std::max(best, intersectionOverUnion(building.footprint(), other.footprint()));
    sum += best / static_cast<double>(truth.buildings.size());
  }
  return sum;
}

TEST_F(TraceCommand, LeadsFromAPhotoToACorrectedMap) {
  writePlace("world.handmap");
  ASSERT_EQ(run({"simulate", "--world", "world.handmap", "--seed", "3", "--out", "place"}).status,
            0);
  const Sheet sheet = emptySheet(SheetCode{20.0, false});
  cv::Mat print = test::printed(sheet);
  drawOn(print, sheet, readMap("place/sketch.handmap"));
  cv::imwrite("photo.png", test::photographed(print, {0.5, 2.0, 1.2, 0.3, 0.5, 2.0, 4}));
  expectDone(run({"trace", "photo.png", "--out", "drawing.handmap"}),
             "drawing.handmap: 6 closed shapes taken for buildings, 0 left out\n");
  ASSERT_EQ(
      run({"run", "--map", "drawing.handmap", "--recording", "place", "--out", "refined.handmap"})
          .status,
      0);
  EXPECT_LT(overlapOf("drawing.handmap"), 0.6);
  EXPECT_GT(overlapOf("refined.handmap"), 0.8);
}

TEST_F(TraceCommand, ReadsRealDrawings) {
  const std::filesystem::path folder = std::filesystem::path(HANDMAP_SHARED_DATA) / "sketches";
  if (!exists(folder)) GTEST_SKIP() << "no drawings in " << folder;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() != ".jpg" || file.filename().string().starts_with("basemap")) continue;
    const Outcome done =
        run({"trace", file.string(), "--width", "280", "--out", "drawing.handmap"});
    EXPECT_EQ(done.status, 0) << file << done.err;
    EXPECT_EQ(run({"validate", "drawing.handmap"}).status, 0) << file;
  }
}

}  // namespace
}  // namespace handmap
