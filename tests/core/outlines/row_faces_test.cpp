#include "core/outlines/row_faces.h"

#include <gtest/gtest.h>

#include "core/outlines/constants.h"
#include "drive.h"

namespace handmap {
namespace {

const std::vector<Polygon> kStepped = {Rectangle{{15.0, 12.0}, 10.0, 8.0, 0.0}.corners(),
                                       Rectangle{{25.0, 12.6}, 10.0, 8.0, 0.0}.corners()};
const RowBand kBand{0.0, 10.0, 30.0, 6.0, 18.0};

TEST(RowFaces, AreWhereTheReturnsAre) {
  const Drive drive = drivePast(kStepped);
  const RowFaces faces(placeRays(drive.seen, drive.way), kBand);
  EXPECT_NEAR(faces.across(RowFaces::kLow, 10.0, 20.0).value_or(0.0), 8.0, 0.15);
  EXPECT_NEAR(faces.across(RowFaces::kLow, 20.0, 30.0).value_or(0.0), 8.6, 0.15);
  EXPECT_FALSE(faces.across(RowFaces::kHigh, 10.0, 30.0));  // nobody was behind
  EXPECT_NEAR(faces.turn(), 0.0, 0.01);
}

TEST(RowFaces, TellWhereOneIsSteppedAgainstTheOther) {
  const Drive drive = drivePast(kStepped);
  const RowFaces faces(placeRays(drive.seen, drive.way), kBand);
  const double at_step = faces.evidence(10.0, 20.0) + faces.evidence(20.0, 30.0);
  EXPECT_GT(at_step, faces.evidence(10.0, 17.0) + faces.evidence(17.0, 30.0) + 2.0);
  EXPECT_GT(at_step, faces.evidence(10.0, 23.0) + faces.evidence(23.0, 30.0) + 2.0);
}

TEST(RowFaces, DivideNoHouseForAShedBeforeIt) {
  const Polygon house = Rectangle{{20.0, 12.0}, 20.0, 8.0, 0.0}.corners();
  const Polygon shed = Rectangle{{20.0, 7.0}, 5.0, 1.0, 0.0}.corners();
  const Drive drive = drivePast({house, shed});
  const RowFaces faces(placeRays(drive.seen, drive.way), kBand);
  EXPECT_NEAR(faces.across(RowFaces::kLow, 17.5, 22.5).value_or(0.0), 6.5, 0.15);
  const double divided =
      faces.evidence(10.0, 17.5) + faces.evidence(17.5, 22.5) + faces.evidence(22.5, 30.0);
  EXPECT_LT(divided - faces.evidence(10.0, 30.0), 2.0 * outlines::kTells);
}

TEST(RowFaces, SayHowTheyAreTurned) {
  const double turn = toRadians(3.0);
  const Drive drive = drivePast({Rectangle{{20.0, 12.0}, 20.0, 8.0, turn}.corners()});
  const RowFaces faces(placeRays(drive.seen, drive.way), kBand);
  EXPECT_NEAR(faces.turn(), turn, 0.01);
}

TEST(RowFaces, GoOnAsFarAsWallsDo) {
  const Polygon apart = Rectangle{{37.0, 12.0}, 10.0, 8.0, 0.0}.corners();  // 2 m beyond
  std::vector<Polygon> houses = kStepped;
  houses.push_back(apart);
  const Drive drive = drivePast(houses);
  const RowFaces faces(placeRays(drive.seen, drive.way), {0.0, 0.0, 60.0, 6.0, 18.0});
  const auto [from, to] = faces.seenAround(12.0, 17.0);
  EXPECT_NEAR(from, 10.0, 1.0);  // at a corner it is not clear along which wall it goes on
  EXPECT_NEAR(to, 30.0, 1.0);
  EXPECT_EQ(faces.seenAround(5.0, 55.0), std::pair(5.0, 55.0));
}

TEST(RowFaces, SayNothingOfWhatNobodySaw) {
  const RowFaces faces(PlacedRays{}, kBand);
  EXPECT_EQ(faces.evidence(10.0, 30.0), 0.0);
  EXPECT_EQ(faces.turn(), 0.0);
}

}  // namespace
}  // namespace handmap
