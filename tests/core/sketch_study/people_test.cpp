#include "core/sketch_study/people.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/sketch_study/heavy_tails.h"

namespace handmap {
namespace {

constexpr double kSigma = 15.0;  // of places, metres
constexpr double kSlope = 0.7;   // of ln sizes
constexpr double kSizeSigma = 0.2;

Building house(const std::string& id, const Vec2& centre, double size, double heading) {
  Building building;
  building.id = id;
  building.shape = Rectangle{centre, 1.5 * size, size / 1.5, heading};
  return building;
}

/// Twelve houses of a town, and someone's drawing of all but the first: 2 units a metre, turned.
Sketch townAsDrawn(std::uint32_t person) {
  RandomStream town(3);
  RandomStream hand(5, person);
  const Pose2 turned{40, 10, 0.3};
  Sketch sketch;
  for (int i = 0; i < 12; ++i) {
    const std::string id = std::to_string(i);
    const Vec2 place(town.uniform(0, 300), town.uniform(0, 200));
    const double log_size = town.normal(3.0, 0.5);
    const double heading = town.uniform(0.0, 1.0);
    sketch.truth.buildings.push_back(house(id, place, std::exp(log_size), heading));
    const Vec2 off(hand.normal(0, kSigma), hand.normal(0, kSigma));
    const double drawn = 3.0 + kSlope * (log_size - 3.0) + hand.normal(0, kSizeSigma);
    if (i == 0) continue;
    sketch.drawing.buildings.push_back(house(id, 2.0 * turned.toOuter(place + off),
                                             2.0 * std::exp(drawn), heading + turned.heading));
  }
  return sketch;
}

std::vector<DrawnErrors> drawings(std::uint32_t persons) {
  std::vector<DrawnErrors> all;
  for (std::uint32_t person = 0; person < persons; ++person) {
    all.push_back(*drawnErrors(townAsDrawn(person)));
  }
  return all;
}

TEST(People, AreFoundAgainFromTheirDrawings) {
  const PeopleFigures figures = peopleFigures(drawings(40));
  EXPECT_NEAR(figures.position_m, kSigma, 1.0);
  EXPECT_NEAR(figures.size_slope, kSlope, 0.05);
  EXPECT_NEAR(figures.size_sigma, kSizeSigma, 0.02);
  EXPECT_NEAR(figures.missing, 1.0 / 12.0, 1e-9);
  EXPECT_NEAR(figures.drawing_turn_deg, toDegrees(0.3), 2.0);
  EXPECT_NEAR(figures.neighbour_correlation, 0.0, 0.08);
  EXPECT_DOUBLE_EQ(figures.right_corners, 1.0);
  EXPECT_GT(figures.tail_freedom, 10.0);
}

TEST(People, HaveIntervalsThatFollowFromTheSeed) {
  const std::vector<DrawnErrors> six = drawings(6);
  const std::vector<FigureRange> intervals = peopleIntervals(six, 300, 1);
  const auto& all = allPeopleFigures();
  ASSERT_EQ(intervals.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].value != &PeopleFigures::position_m && all[i].value != &PeopleFigures::size_slope) {
      continue;
    }
    const double truth = all[i].value == &PeopleFigures::position_m ? kSigma : kSlope;
    EXPECT_LT(intervals[i].low, truth) << all[i].name;
    EXPECT_GT(intervals[i].high, truth) << all[i].name;
  }
  EXPECT_EQ(intervals[0].low, peopleIntervals(six, 300, 1)[0].low);
  EXPECT_NE(intervals[0].low, peopleIntervals(six, 300, 2)[0].low);
}

TEST(People, AreForetoldByTheOthers) {
  const std::vector<Foretold> places = foretellPlaces(drawings(20));
  EXPECT_NEAR(places[0].within_68, 0.68, 0.06);
  EXPECT_NEAR(places[0].within_95, 0.95, 0.04);
  EXPECT_GT(places[0].normal_score, places[2].normal_score);  // errors are the same everywhere
  const std::vector<Foretold> sizes = foretellSizes(drawings(20));
  EXPECT_GT(sizes[2].normal_score, sizes[1].normal_score);  // sizes are pulled to the mean
}

TEST(HeavyTails, AreToldFromNormalOnes) {
  RandomStream random(1);
  std::vector<double> normal;
  std::vector<double> heavy;
  for (int i = 0; i < 2000; ++i) {
    normal.push_back(random.normal(0, 2));
    heavy.push_back(random.normal(0, 1) / std::abs(random.normal()));  // of one degree of freedom
  }
  EXPECT_GE(fitHeavyTails(normal).freedom, 20.0);
  EXPECT_NEAR(fitHeavyTails(normal).sigma, 2.0, 0.15);
  EXPECT_LE(fitHeavyTails(heavy).freedom, 1.5);
}

}  // namespace
}  // namespace handmap
