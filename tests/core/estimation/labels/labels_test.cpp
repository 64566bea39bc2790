#include "core/estimation/labels/labels.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace handmap {
namespace {

constexpr double kNear = 150.0;

/// A street of buildings every 40 m, drawn 2 m too far along it.
class LabelsTest : public testing::Test {
 protected:
  LabelsTest() {
    drawing_.start = Pose2{};
    drawing_.uncertainty = {3.0, 3.0};
    for (int i = 0; i < 20; ++i) {
      Building building;
      building.id = std::to_string(i);
      building.shape = Rectangle{{40.0 * i + 2.0, 15.0}, 20.0, 10.0, 0.0};
      drawing_.buildings.push_back(building);
    }
  }

  /// Drives to x and finds what stands within 40 m.
  void driveTo(Labels& labels, double x) {
    for (; at_ <= x; at_ += 10.0) {
      for (; known_ < 20 && 40.0 * known_ < at_ + 40.0; ++known_) {
        found_.push_back({boxOf({{40.0 * known_, 15.0}, 20.0, 10.0, 0.0}), 100.0,
                          0.01 * Eigen::Matrix4d::Identity(), 0.001, 9});
        found_.back().id = static_cast<FoundId>(known_);
      }
      update(labels, {at_, 0.0, 0.0});
    }
  }
  void update(Labels& labels, const Pose2& pose) {
    way_.push_back(pose);
    for (FoundBox& found : found_) {
      found.in_sight = (found.box.rectangle().centre - pose.position()).norm() < 60.0;
    }
    labels.update(found_, way_, kNear);
  }
  double foundAt(const Labels& labels, std::size_t building) const {
    const FoundBox* found = labels.of(building, found_).found;
    return found ? found->box.rectangle().centre.x() : std::numeric_limits<double>::quiet_NaN();
  }

  Map drawing_;
  std::vector<FoundBox> found_;
  std::vector<Pose2> way_;
  double at_ = 0.0;
  int known_ = 0;
};

TEST_F(LabelsTest, FarBuildingsKeepTheirLabels) {
  Labels labels(drawing_, {});
  driveTo(labels, 500.0);
  EXPECT_LE(found_.size(), 6u);
  EXPECT_LE(labels.nearby().size(), 9u);
  EXPECT_EQ(labels.settledCount() + found_.size(), static_cast<std::size_t>(known_));
  for (std::size_t b = 0; b < static_cast<std::size_t>(known_); ++b) {
    EXPECT_EQ(foundAt(labels, b), 40.0 * static_cast<double>(b)) << b;
  }
  EXPECT_EQ(labels.of(19, found_).found, nullptr);
}

TEST_F(LabelsTest, WhoComesBackFindsThemAgain) {
  Labels labels(drawing_, {});
  driveTo(labels, 500.0);
  for (double x = 490.0; x >= 40.0; x -= 10.0) {
    update(labels, {x, 0.0, kPi});
  }
  EXPECT_EQ(labels.nearby().front(), 0u);
  ASSERT_NE(labels.of(1, found_).found, nullptr);
  EXPECT_EQ(labels.of(1, found_).found->id, static_cast<FoundId>(1));
  EXPECT_EQ(labels.drawnOf(static_cast<FoundId>(1)), 1u);
  for (std::size_t b = 0; b < static_cast<std::size_t>(known_); ++b) {
    EXPECT_EQ(foundAt(labels, b), 40.0 * static_cast<double>(b)) << b;
  }
}

TEST_F(LabelsTest, LabelsGoWithTheBuildingsInWhateverOrderTheyAre) {
  Labels labels(drawing_, {});
  driveTo(labels, 500.0);
  std::reverse(found_.begin(), found_.end());
  for (std::size_t b = 0; b < static_cast<std::size_t>(known_); ++b) {
    EXPECT_EQ(foundAt(labels, b), 40.0 * static_cast<double>(b)) << b;
  }
  const FoundId gone = found_.front().id;
  const std::size_t drawn = *labels.drawnOf(gone);
  found_.erase(found_.begin());  // given up since
  EXPECT_EQ(labels.of(drawn, found_).found, nullptr);
}

TEST_F(LabelsTest, ThePriorNamesItsBoxes) {
  Labels labels(drawing_, {});
  driveTo(labels, 500.0);
  const DrawingPrior prior = labels.prior(3, found_);
  EXPECT_EQ(prior.anchors.size(), 3 + found_.size());
  for (const DrawingPrior::Anchor& anchor : prior.anchors) {
    EXPECT_EQ(anchor.drawn, &drawing_.buildings[static_cast<std::size_t>(anchor.box)]);
  }
}

TEST_F(LabelsTest, FarBuildingsStillTellHowTheDrawingLies) {
  for (Building& building : drawing_.buildings) {
    Rectangle box = building.box();
    box.centre.x() *= 1.04;
    building.shape = box;
  }
  Labels labels(drawing_, {});
  driveTo(labels, 700.0);
  EXPECT_NEAR(labels.motion().scale(), 1.0 / 1.04, 0.01);
}

TEST_F(LabelsTest, HousesThatAreTurnedByMuchTellThatTheDrawingKnowsNoHeadings) {
  for (std::size_t b = 0; b < drawing_.buildings.size(); ++b) {
    Rectangle box = drawing_.buildings[b].box();
    box.heading = toRadians(b % 2 == 0 ? 20.0 : -20.0);
    drawing_.buildings[b].shape = box;
  }
  Labels labels(drawing_, {});
  driveTo(labels, 100.0);
  EXPECT_GT(labels.headingScatter(found_), toRadians(8.0));
}

TEST_F(LabelsTest, AMissedBuildingStaysDoubtful) {
  Building phantom;
  phantom.id = "phantom";
  phantom.shape = Rectangle{{60.0, -15.0}, 20.0, 10.0, 0.0};
  drawing_.buildings.push_back(phantom);
  Labels labels(drawing_, {});
  driveTo(labels, 500.0);
  EXPECT_EQ(labels.of(20, found_).found, nullptr);
  EXPECT_GT(labels.of(20, found_).doubt, 0.9);
}

}  // namespace
}  // namespace handmap
