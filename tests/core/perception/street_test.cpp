// How much of what is taken for walls in a real street lies on true walls.
#include <array>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>

#include <gtest/gtest.h>

#include "core/map/map_io.h"
#include "core/perception/range_walls.h"
#include "core/perception/stereo_walls.h"
#include "core/recording/recording.h"

namespace handmap {
namespace {

const std::filesystem::path kStreet = std::filesystem::path(HANDMAP_SHARED_DATA) / "street";
constexpr double kOnWall_m = 0.5;
constexpr double kBand_m = 5.0;
const Bounds kHedge{{203.0, 3.0}, {222.0, 7.5}};  // the one beside L9

/// Front and side walls; rear walls are never seen and their place is assumed.
std::vector<Segment> visibleWalls(const Map& map) {
  std::vector<Segment> walls;
  for (const Building& building : map.buildings) {
    const Polygon corners = building.footprint();
    const Vec2 centre = centroid(corners);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Segment wall{corners[i], corners[(i + 1) % corners.size()]};
      const Vec2 middle = 0.5 * (wall.a + wall.b);
      const bool along = std::abs(wall.a.x() - wall.b.x()) > std::abs(wall.a.y() - wall.b.y());
      const bool rear = along && std::abs(middle.y()) > std::abs(centre.y());
      if (!rear) walls.push_back(wall);
    }
  }
  return walls;
}

class Street : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kStreet)) GTEST_SKIP() << "no street recording";
    recording_ = openRecording(kStreet);
    walls_ = visibleWalls(readMap(kStreet / "truth.handmap"));
  }

  void score(const Observation& observation, const std::vector<WallPoint>& points) {
    const Pose2 truth = recording_.truth.at(observation.time_s).value();
    for (const WallPoint& point : points) {
      double distance = std::numeric_limits<double>::infinity();
      const Vec2 place = truth.toOuter({point.x, point.y});
      for (const Segment& wall : walls_) distance = std::min(distance, distanceTo(wall, place));
      const auto band = static_cast<std::size_t>(std::hypot(point.x, point.y) / kBand_m);
      const auto weight = static_cast<double>(point.weight);
      bands_.at(band).points += weight;
      if (distance < kOnWall_m) bands_.at(band).on_wall += weight;
      if (kHedge.overlaps({place, place})) hedge_ += weight;
    }
  }

  /// Prints the table and returns the share of the points, by their weights, on true walls.
  double share() const {
    double points = 0.0;
    double on_wall = 0.0;
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      if (bands_[i].points == 0.0) continue;
      std::cout << "  " << std::setw(2) << i * 5 << "-" << std::setw(2) << i * 5 + 5
                << " m: " << std::setw(6) << std::lround(bands_[i].points) << " points, "
                << std::setw(3) << std::lround(100.0 * bands_[i].on_wall / bands_[i].points)
                << " % on true walls\n";
      points += bands_[i].points;
      on_wall += bands_[i].on_wall;
    }
    return points == 0 ? 0.0 : static_cast<double>(on_wall) / points;
  }

  struct Band {
    double points = 0.0;
    double on_wall = 0.0;
  };
  Recording recording_;
  std::vector<Segment> walls_;
  std::array<Band, 9> bands_{};
  double hedge_ = 0.0;  ///< what was taken for a wall beside L9
};

TEST_F(Street, LidarWalls) {
  const auto source = replay(recording_, {.from = 40, .kind = SourceKind::Points});
  RangeWalls walls(40.0, {});
  while (const auto observation = source->next()) {
    score(*observation, walls(*observation->views[0].points, observation->odometry));
  }
  EXPECT_GT(share(), 0.48);
}

TEST_F(Street, StereoWallsWithAndWithoutTheClassifier) {
  double share_before = 0.0;
  double hedge_before = 0.0;
  for (const bool judged : {false, true}) {
    bands_ = {};
    hedge_ = 0.0;
    const auto source = replay(recording_, {.from = 40, .every = 5, .kind = SourceKind::Images});
    std::optional<WallJudge> judge;
    if (judged) judge.emplace(nullptr);
    StereoWalls stereo(recording_.camera.value(), {}, std::move(judge));
    while (const auto observation = source->next()) {
      const View& view = observation->views[0];
      score(*observation, stereo(view.left, view.right, view.pan, 40.0).walls);
    }
    const double on_walls = share();
    std::cout << "  " << on_walls << " on true walls, the hedge " << hedge_ << "\n";
    if (judged) {
      EXPECT_GT(on_walls, share_before + 0.05);
      EXPECT_LT(hedge_, 0.75 * hedge_before);
    } else {
      EXPECT_GT(on_walls, 0.52);
    }
    share_before = on_walls;
    hedge_before = hedge_;
  }
}

}  // namespace
}  // namespace handmap
