#include "core/method/doubt.h"

#include <gtest/gtest.h>

#include "core/map/certainty.h"

namespace handmap {
namespace {

class DoubtTest : public testing::Test {
 protected:
  DoubtTest() {
    drawing_.uncertainty = {1.0, 1.0};
    for (int i = 0; i < 4; ++i) {
      Building building;
      building.id = "B" + std::to_string(i);
      building.shape = Rectangle{{20.0 * i, 0.0}, 10.0, 10.0, 0.0};
      drawing_.buildings.push_back(building);
    }
    refined_ = drawing_;
    for (Building& building : refined_.buildings) building.estimate = Estimate{0.1, 0.1, 0.1, 5};
  }
  std::vector<double> doubts() {
    stateDoubt(drawing_, refined_);
    std::vector<double> doubts;
    for (const Building& building : refined_.buildings) doubts.push_back(doubtOf(building));
    return doubts;
  }
  Map drawing_;
  Map refined_;
};

TEST_F(DoubtTest, IsNeverSurerThanBuildingsProvedToBe) {
  refined_.buildings[0].estimate->observations = 0;
  refined_.buildings[0].doubt = 1.0;  // as labels say
  refined_.buildings[1].doubt = 0.2;  // of such none was wrong
  const std::vector<double> stated = doubts();
  EXPECT_EQ(stated[0], 0.4);
  EXPECT_EQ(stated[1], 0.0);
  EXPECT_EQ(stated[2], 0.0);
}

TEST_F(DoubtTest, BuildingsThatStandInEachOtherAreDoubtfulBeforeTheyAreAccepted) {
  std::get<Rectangle>(refined_.buildings[2].shape).centre.x() = 55.0;
  const std::vector<double> stated = doubts();
  EXPECT_GT(stated[2], 0.0);
  EXPECT_GT(stated[3], 0.0);
  EXPECT_EQ(stated[1], 0.0);
}

TEST_F(DoubtTest, WhatWasProbablyFittedToSomethingElseIsDoubtfulAndWhatTurnedIsNot) {
  std::get<Rectangle>(refined_.buildings[1].shape).centre.y() = 4.0;
  std::get<Rectangle>(refined_.buildings[2].shape).heading = toRadians(20.0);
  const std::vector<double> stated = doubts();
  EXPECT_EQ(stated[1], 0.4);
  EXPECT_EQ(stated[2], 0.0);
}

TEST_F(DoubtTest, AFixedBuildingKeepsWhatItHad) {
  drawing_.buildings[0].fixed = true;
  refined_.buildings[0].doubt = 0.7;
  EXPECT_EQ(doubts()[0], 0.7);
}

}  // namespace
}  // namespace handmap
