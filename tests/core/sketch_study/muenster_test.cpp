// Six people's drawings of two places in Münster, where they are.
#include <gtest/gtest.h>

#include "core/sketch_study/people.h"

namespace handmap {
namespace {

TEST(Muenster, SizesArePulledToTheMeanAndTheOrderIsKept) {
  const std::filesystem::path folder = std::filesystem::path(HANDMAP_SHARED_DATA) / "sketches";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no sketches";
  std::vector<DrawnErrors> drawings;
  for (const auto& [map, name] : {std::pair(1, "1a"), std::pair(2, "1b"), std::pair(3, "1c"),
                                  std::pair(4, "1d"), std::pair(5, "2a"), std::pair(6, "2b")}) {
    const std::string stem = std::string("sketchMap") + name;
    const auto input = folder / ("sketchMap" + std::to_string(map)) / (stem + "Input");
    drawings.push_back(
        *drawnErrors(readSketch(input / (stem + ".jpg.geojson"), input / "basemap.geojson", 0.33)));
  }
  const PeopleFigures figures = peopleFigures(drawings);
  EXPECT_NEAR(figures.position_of_extent, 0.23, 0.01);
  EXPECT_NEAR(figures.size_slope, 0.73, 0.01);
  EXPECT_GT(figures.order_kept, 0.9);
  EXPECT_LT(figures.corners, figures.true_corners);
  const std::vector<Foretold> sizes = foretellSizes(drawings);
  EXPECT_GT(sizes[2].normal_score, sizes[0].normal_score);
}

}  // namespace
}  // namespace handmap
