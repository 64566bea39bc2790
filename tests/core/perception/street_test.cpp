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
      ++bands_.at(band).points;
      if (distance < kOnWall_m) ++bands_.at(band).on_wall;
    }
  }

  /// Prints the table and returns the share of points on true walls.
  double share() const {
    int points = 0;
    int on_wall = 0;
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      if (bands_[i].points == 0) continue;
      std::cout << "  " << std::setw(2) << i * 5 << "-" << std::setw(2) << i * 5 + 5
                << " m: " << std::setw(6) << bands_[i].points << " points, " << std::setw(3)
                << 100 * bands_[i].on_wall / bands_[i].points << " % on true walls\n";
      points += bands_[i].points;
      on_wall += bands_[i].on_wall;
    }
    return points == 0 ? 0.0 : static_cast<double>(on_wall) / points;
  }

  struct Band {
    int points = 0;
    int on_wall = 0;
  };
  Recording recording_;
  std::vector<Segment> walls_;
  std::array<Band, 9> bands_{};
};

TEST_F(Street, LidarWalls) {
  const auto source = replay(recording_, {.from = 40, .kind = SourceKind::Points});
  RangeWalls walls(40.0, {});
  while (const auto observation = source->next()) {
    score(*observation, walls(*observation->views[0].points, observation->odometry));
  }
  EXPECT_GT(share(), 0.48);
}

TEST_F(Street, StereoWalls) {
  const auto source = replay(recording_, {.from = 40, .every = 10, .kind = SourceKind::Images});
  StereoWalls stereo(recording_.camera.value(), {});
  while (const auto observation = source->next()) {
    const View& view = observation->views[0];
    score(*observation, stereo(view.left, view.right, view.pan, 40.0).walls);
  }
  EXPECT_GT(share(), 0.52);
}

}  // namespace
}  // namespace handmap
