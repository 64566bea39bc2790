#include "core/outlines/refinement.h"

#include <gtest/gtest.h>

#include "tests/core/outlines/drive.h"

namespace handmap {
namespace {

Map drawingOf(const Rectangle& box, double sigma_m) {
  Map map;
  map.start = Pose2{};
  map.uncertainty = {sigma_m, sigma_m};
  Building building;
  building.id = "A";
  building.shape = box;
  map.buildings.push_back(building);
  return map;
}

const Rectangle kDrawn{{20.0, 12.0}, 14.0, 8.0, 0.0};

TEST(Refinement, KeepsWhatWasFoundWhereOutlinesCannotBeFitted) {
  const Map drawing = drawingOf(kDrawn, 0.5);  // sure of itself
  Map found = drawing;
  found.buildings[0].shape = Rectangle{{20.6, 12.3}, 14.0, 8.0, 0.0};
  found.buildings[0].estimate = Estimate{0.1, 0.1, 0.1, 12};
  const Drive drive = drivePast({});
  const auto map = refine(drawing, FoundMap{found, DrawingMotion{}}, drive.seen, drive.way, 1);
  ASSERT_TRUE(map);
  EXPECT_NEAR(map->buildings[0].box().centre.x(), 20.6, 1e-6);
}

TEST(Refinement, SaysNoMoreOfADrawnPlaceThanTheDrawing) {
  // Found 60 m from all walls, drawn where there is nothing to tell it either.
  const Rectangle far{{30.0, -150.0}, 14.0, 8.0, 0.0};
  const Map drawing = drawingOf(far, 0.5);
  Map found = drawing;
  found.buildings[0].estimate = Estimate{0.1, 0.1, 0.1, 12};
  const Drive drive = drivePast({kDrawn.corners()});
  const auto map = refine(drawing, FoundMap{found, DrawingMotion{}}, drive.seen, drive.way, 1);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->buildings[0].estimate, (Estimate{0.5, 0.5, 0.5, 0}));
}

}  // namespace
}  // namespace handmap
