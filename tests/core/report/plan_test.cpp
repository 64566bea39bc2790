#include "core/report/plan.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "tests/core/base/expect_error.h"

namespace handmap {
namespace {

/// As high as wide, corners 10 m from the middle; the other one corrected.
Map place() {
  Map map;
  map.name = "Our <street>";
  Building house;
  house.id = "N1";
  house.name = "\xE9\xA7\x85";  // a station
  house.shape = Rectangle{{0.0, 0.0}, 20.0, 20.0, 0.0};
  map.buildings = {house};
  house.id = "N2";
  house.name.clear();
  house.shape = Rectangle{{40.0, 0.0}, 20.0, 20.0, 0.0};
  house.estimate = Estimate{0.2, 0.2, 0.2, 9};
  map.buildings.push_back(house);
  map.start = Pose2{20.0, 0.0, 0.0};
  return map;
}

TEST(Plan, AsSvgHasOutlinesNamesScaleAndLegend) {
  const std::string svg = formatPlan(place(), "plan.svg");
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  for (const char* text :
       {"\xE9\xA7\x85</text>", "N2</text>", "Our &lt;street></text>", "10 m</text>", "drawn</text>",
        "corrected</text>", "start and way</text>"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text << "\n" << svg;
  }
  EXPECT_EQ(svg.find("doubtful"), std::string::npos) << "nothing is";
}

TEST(Plan, IsToScale) {
  const cv::Mat png = [] {
    const std::string file = formatPlan(place(), "plan.png");
    const std::vector<unsigned char> bytes(file.begin(), file.end());
    return cv::imdecode(bytes, cv::IMREAD_COLOR);
  }();
  ASSERT_EQ(png.cols, 297 * 8);
  // 60 m from wall to wall fill the sheet but for its margins; the corrected one is blue.
  const auto blue = [&](int x) {
    const auto pixel = png.at<cv::Vec3b>(png.rows / 2, x);
    return pixel[0] > 180 && pixel[2] < 100;
  };
  int first = 0;
  while (first < png.cols && !blue(first)) ++first;
  int last = png.cols - 1;
  while (last > 0 && !blue(last)) --last;
  const double per_metre = 8.0 * (297.0 - 24.0) / 60.0;
  EXPECT_NEAR(first, 8.0 * 12.0 + 40.0 * per_metre, 4.0);
  EXPECT_NEAR(last, 8.0 * (297.0 - 12.0), 4.0);
}

TEST(Plan, IsAPdfToo) {
  const std::string pdf = formatPlan(place(), "plan.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF"));
  EXPECT_NE(pdf.find("<99C5> Tj"), std::string::npos);
}

TEST(Plan, OfNothingIsRefused) {
  test::expectBadInput([] { formatPlan({}, "plan.svg"); }, {"plan.svg", "buildings"});
  test::expectBadInput([] { formatPlan(place(), "plan.bmp"); }, {"plan.bmp", "pdf, svg, png"});
}

}  // namespace
}  // namespace handmap
