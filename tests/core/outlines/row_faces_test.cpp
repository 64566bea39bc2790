#include "core/outlines/row_faces.h"

#include <gtest/gtest.h>

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

TEST(RowFaces, SayHowTheyAreTurned) {
  const double turn = toRadians(3.0);
  const Drive drive = drivePast({Rectangle{{20.0, 12.0}, 20.0, 8.0, turn}.corners()});
  const RowFaces faces(placeRays(drive.seen, drive.way), kBand);
  EXPECT_NEAR(faces.turn(), turn, 0.01);
}

TEST(RowFaces, SayNothingOfWhatNobodySaw) {
  const RowFaces faces(PlacedRays{}, kBand);
  EXPECT_EQ(faces.evidence(10.0, 30.0), 0.0);
  EXPECT_EQ(faces.turn(), 0.0);
}

}  // namespace
}  // namespace handmap
