#include "core/simulation/drawn_by_people.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace handmap {
namespace {

/// So far apart that nothing is in the way of an error.
Map fields() {
  Map map;
  for (int i = 0; i < 12; ++i) {
    Building building;
    building.id = std::to_string(i);
    const double size = i % 2 == 0 ? 5.0 : 20.0;
    building.shape = Rectangle{{200.0 * (i % 4), 200.0 * (i / 4)}, size, size, 0.0};
    map.buildings.push_back(building);
  }
  map.buildings[1].shape =
      Polygon{{180, -10}, {220, -10}, {220, 0}, {190, 0}, {190, 10}, {180, 10}};
  return map;
}

double sizeOf(const Building& building) { return std::sqrt(signedArea(building.footprint())); }

TEST(DrawnByPeople, HasTheErrorsOfPeople) {
  const Map truth = fields();
  PeopleErrors errors;
  errors.missing = 0.0;
  errors.position = 0.05;
  double square = 0.0;
  double product = 0.0;
  double small = 0.0;
  double large = 0.0;
  constexpr int kDrawings = 200;
  for (std::uint64_t seed = 1; seed <= kDrawings; ++seed) {
    const Map drawn = drawnByPeople(truth, errors, seed);
    ASSERT_EQ(drawn.buildings.size(), truth.buildings.size());
    std::vector<Vec2> off;
    for (std::size_t i = 0; i < truth.buildings.size(); ++i) {
      EXPECT_TRUE(std::holds_alternative<Rectangle>(drawn.buildings[i].shape));
      off.push_back(drawn.buildings[i].box().centre - truth.buildings[i].box().centre);
      square += off.back().squaredNorm() / 2.0 / 12.0 / kDrawings;
    }
    product += off[0].dot(off[1]) / 2.0 / kDrawings;
    small += std::log(sizeOf(drawn.buildings[2]) / 5.0) / kDrawings;
    large += std::log(sizeOf(drawn.buildings[3]) / 20.0) / kDrawings;
  }
  const double sigma = errors.position * extentOf(truth);
  EXPECT_NEAR(std::sqrt(square), sigma, 0.1 * sigma);
  const double neighbours = std::exp(-200.0 / (errors.reach * extentOf(truth)));
  EXPECT_NEAR(product / (sigma * sigma), neighbours, 0.15);
  EXPECT_GT(small, 0.1);  // pulled to the mean
  EXPECT_LT(large, -0.1);
}

TEST(DrawnByPeople, SaysItsErrorsAndFollowsFromTheSeed) {
  const Map truth = fields();
  const Map drawn = drawnByPeople(truth, {}, 7);
  EXPECT_EQ(drawn, drawnByPeople(truth, {}, 7));
  EXPECT_NE(drawn, drawnByPeople(truth, {}, 8));
  EXPECT_NEAR(drawn.uncertainty.position, 0.23 * extentOf(truth), 1e-9);
  EXPECT_GT(drawn.uncertainty.size, 1.0);
}

TEST(DrawnByPeople, MissesSomeBuildingsAndKeepsThreeAndTheFixed) {
  PeopleErrors errors;
  errors.missing = 1.0;
  Map truth = fields();
  EXPECT_EQ(drawnByPeople(truth, errors, 1).buildings.size(), PeopleErrors::kLeast);
  truth.buildings[0].fixed = true;
  const Map drawn = drawnByPeople(truth, errors, 1);
  ASSERT_NE(drawn.find("0"), nullptr);
  EXPECT_EQ(drawn.find("0")->shape, truth.buildings[0].shape);
  std::size_t left = 0;
  errors.missing = 0.2;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    left += drawnByPeople(fields(), errors, seed).buildings.size();
  }
  EXPECT_NEAR(static_cast<double>(left) / 1200.0, 0.8, 0.05);
}

TEST(DrawnByPeople, KeepsSideAndOrder) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Map truth = twoRowWorld(seed).map;
    PeopleErrors errors;
    errors.missing = 0.0;
    const Map drawn = drawnByPeople(truth, errors, seed);
    for (const std::size_t row : {0U, 3U}) {
      EXPECT_LT(drawn.buildings[row].box().centre.x(), drawn.buildings[row + 1].box().centre.x());
    }
  }
}

TEST(DrawnByPeople, RefusesATown) {
  Map truth;
  truth.buildings.resize(1001);
  EXPECT_THROW(drawnByPeople(truth, {}, 1), Error);
}

}  // namespace
}  // namespace handmap
