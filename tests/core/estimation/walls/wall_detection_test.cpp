#include "core/estimation/walls/wall_detection.h"

#include <algorithm>
#include <array>
#include <span>

#include <gtest/gtest.h>

#include "tests/core/estimation/scene.h"

namespace handmap {
namespace {

constexpr double kDetectionCell = 0.5;
constexpr double kReach = 40.0;

/// Scores of all runs that are walls, along every row and tilt: the plain way.
std::vector<double> plainScores(const WallEvidence& evidence, const Vec2& middle,
                                std::span<const double> tilts = walls::kTilts) {
  std::vector<double> scores;
  for (const WallImage& image : evidence.images()) {
    const auto at = [](double metres) { return static_cast<int>(metres / kDetectionCell); };
    const int low = at(image.along().dot(middle) - kReach);
    const int high = at(image.along().dot(middle) + kReach);
    const double across = image.across().dot(middle);
    for (const double tilt : tilts) {
      for (int row = at(across - kReach); row < at(across + kReach); ++row) {
        double sum = 0.0;
        double peak = 0.0;
        int begin = 0;
        int peak_at = 0;
        const auto close = [&] {
          if (peak >= walls::kLeastScore &&
              (peak_at - begin) * kDetectionCell >= walls::kLeastWall_m) {
            scores.push_back(peak);
          }
          sum = peak = 0.0;
        };
        for (int column = low; column < high; ++column) {
          const int centre = (low + high) / 2;
          const double off = std::tan(tilt) * (column - centre);
          const double value = image.at(column, row + static_cast<int>(std::lround(off)));
          if (sum == 0.0 && value <= 0.0) continue;
          if (sum == 0.0) begin = column;
          sum += value;
          if (sum > peak) {
            peak = sum;
            peak_at = column;
          } else if (value != 0.0 && (sum <= 0.0 || sum < peak - walls::kDrop)) {
            close();
          }
        }
        close();
      }
    }
  }
  std::sort(scores.rbegin(), scores.rend());
  return scores;
}

class WallDetectionTest : public testing::Test {
 protected:
  WallDetectionTest() : evidence_(kDetectionCell, 200.0) {
    evidence_.include(0.05, {});
    evidence_.include(0.6, {});
  }
  void see(const std::vector<Box>& boxes, std::uint64_t seed) {
    RandomStream random(seed);
    for (double x = -12.0; x <= 12.0; x += 3.0) {
      Frame frame = seenFrom({x, 0.0, 0.1}, boxes, 0.2, random);
      evidence_.add({&frame, frame.pose, sensor_});
    }
  }
  WallEvidence evidence_;
  std::shared_ptr<const SensorModel> sensor_ =
      std::make_shared<const SensorModel>(MeasuredSensor{}, kReach);
};

TEST_F(WallDetectionTest, FindsWhatAPlainSearchOfAllRowsFinds) {
  see({boxOf({{-8.0, 14.0}, 14.0, 8.0, 0.05}), boxOf({{14.0, 18.0}, 10.0, 9.0, 0.11}),
       boxOf({{2.0, -15.0}, 18.0, 6.0, 0.6})},
      7);
  for (const Vec2& middle : {Vec2(0.0, 0.0), Vec2(9.3, -4.1)}) {
    const std::vector<double> plain = plainScores(evidence_, middle);
    const auto walls = detectWalls(evidence_, middle, kReach);
    ASSERT_GE(walls.size(), 3U);
    EXPECT_EQ(walls.front().score, plain.front());
    for (const FoundWall& wall : walls) {
      EXPECT_TRUE(std::count(plain.begin(), plain.end(), wall.score)) << wall.score;
    }
    // Of those that lie on one another the surest alone is kept; without others all are.
    constexpr std::array kStraight{0.0};
    EXPECT_EQ(detectWalls(evidence_, middle, kReach, kStraight).front().score,
              plainScores(evidence_, middle, kStraight).front());
  }
}

TEST_F(WallDetectionTest, ATiltedWallIsFoundAsItStands) {
  see({boxOf({{0.0, 14.0}, 24.0, 8.0, 0.05 + toRadians(3.0)})}, 8);
  const auto walls = detectWalls(evidence_, Vec2::Zero(), kReach);
  ASSERT_FALSE(walls.empty());
  EXPECT_NEAR(walls.front().heading(), 0.05 + toRadians(3.0), toRadians(1.6));
  EXPECT_NEAR(walls.front().length(), 24.0, 3.0);
}

TEST_F(WallDetectionTest, WithoutEvidenceThereIsNoWall) {
  EXPECT_TRUE(detectWalls(evidence_, Vec2::Zero(), kReach).empty());
}

}  // namespace
}  // namespace handmap
