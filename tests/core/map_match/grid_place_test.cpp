#include "core/map_match/grid_place.h"

#include <set>

#include <gtest/gtest.h>

#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/recording/trajectory.h"
#include "core/simulation/simulated_source.h"

namespace handmap {
namespace {

/// The map that another robot makes of a drive: cells in which something was seen twice and cells
/// that were looked through, in a frame of its own.
class Mapper {
 public:
  void add(const Pose2& robot, const std::vector<RangePoint>& points) {
    const Vec2 from = kFrame.toOwn(robot.position());
    for (const RangePoint& p : points) {
      const Vec2 to = kFrame.toOwn(robot.toOuter({p.x, p.y}));
      const double range = (to - from).norm();
      for (double at = 0.0; at < range - 1.0; at += 0.5) {
        free_.insert(cellOf(from + at / range * (to - from)));
      }
      ++hits_[cellOf(to)];
    }
  }
  SeenGround seen() const {
    SeenGround seen;
    seen.cell_m = kCell_m;
    for (const auto& [cell, hits] : hits_) {
      if (hits > 1) seen.edges.push_back(middleOf(cell));
    }
    for (const Cell& cell : free_) {
      if (!hits_.contains(cell)) seen.free.push_back(middleOf(cell));
    }
    return seen;
  }

  static constexpr Pose2 kFrame{-37.0, 52.0, 2.1};

 private:
  using Cell = std::pair<int, int>;
  static constexpr double kCell_m = 0.1;
  static Cell cellOf(const Vec2& p) {
    const Vec2 cell = (p / kCell_m).array().floor();
    return {static_cast<int>(cell.x()), static_cast<int>(cell.y())};
  }
  static Vec2 middleOf(const Cell& cell) {
    return kCell_m * Vec2(cell.first + 0.5, cell.second + 0.5);
  }
  std::map<Cell, int> hits_;
  std::set<Cell> free_;
};

void expectFound(const std::optional<GridPlace>& found, double metres, double degrees) {
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->fits);
  EXPECT_FALSE(found->other) << found->other->x << " " << found->other->y;
  EXPECT_LT((found->pose.position() - Mapper::kFrame.position()).norm(), metres);
  EXPECT_LT(std::abs(normalizedAngle(found->pose.heading - Mapper::kFrame.heading)),
            toRadians(degrees));
}

bool isCertain(const std::optional<GridPlace>& found) {
  return found && found->fits && !found->other;
}

void addBuilding(World& world, const std::string& id, const Rectangle& box) {
  Building building;
  building.id = id;
  building.shape = box;
  world.map.buildings.push_back(building);
}

World world() {
  World world;
  const auto add = [&](const char* id, double x, double y, double width, double depth) {
    addBuilding(world, id, Rectangle{{x, y}, width, depth, 0.0});
  };
  add("a", 15.0, 18.0, 20.0, 10.0);
  add("b", 50.0, 22.0, 30.0, 14.0);
  add("c", 20.0, -16.0, 34.0, 12.0);
  add("d", 62.0, -20.0, 18.0, 18.0);
  world.map.start = Pose2{-10.0, 0.0, 0.0};
  world.map.route = {{-10.0, 0.0}, {85.0, 0.0}};
  return world;
}

SeenGround mapOf(const World& world) {
  const auto source = simulate(world, laserOnTheMove(1.0), 5);
  Mapper mapper;
  for (std::size_t i = 0; const auto observation = source->next(); ++i) {
    mapper.add(source->info().truth[i].pose, *observation->views[0].points);
  }
  return mapper.seen();
}

TEST(GridPlace, IsFoundFromAnywhere) {
  const World true_world = world();
  const SeenGround seen = mapOf(true_world);
  Map drawing = true_world.map;
  drawing.uncertainty.position = 0.5;
  const auto found = placeOf(seen, drawing);
  expectFound(found, 0.3, 0.3);
  EXPECT_GT(found->supported, 0.7);
  EXPECT_LT(found->median_m, 0.2);
  EXPECT_LE(found->median_m, found->most_m);
  EXPECT_NEAR(found->scale, 1.0, 0.02);
}

TEST(GridPlace, SaysThatTheDrawingIsOfAnotherScale) {
  const World true_world = world();
  Map drawing = true_world.map;
  for (Building& building : drawing.buildings) {
    auto& box = std::get<Rectangle>(building.shape);
    box = {1.06 * box.centre, 1.06 * box.width, 1.06 * box.depth, 0.0};
  }
  const auto found = placeOf(mapOf(true_world), drawing);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->scale, 1.06, 0.02);
  EXPECT_LT(found->scale_sigma, 0.03);
}

TEST(GridPlace, SaysWhereElseItMayLie) {
  World square = world();
  for (const Building& building : world().map.buildings) {  // the same once more, turned about
    auto box = std::get<Rectangle>(building.shape);
    box.centre = {-140.0 - box.centre.x(), -box.centre.y()};
    addBuilding(square, building.id + "2", box);
  }
  const auto found = placeOf(mapOf(world()), square.map);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->other);
}

TEST(GridPlace, NothingLiesNowhere) {
  EXPECT_FALSE(placeOf({}, world().map));
  EXPECT_FALSE(placeOf(mapOf(world()), Map()));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(placeOf(mapOf(world()), world().map, stop.get_token()));
}

const std::filesystem::path kData = HANDMAP_SHARED_DATA;

SeenGround realMap(const std::string& place) {
  ReplayOptions options;
  options.kind = SourceKind::Points;
  options.every = place == "campus" ? 4 : 1;
  const auto source = replay(openRecording(kData / place), options);
  const Trajectory truth(source->info().truth, place);
  Mapper mapper;
  while (const auto observation = source->next()) {
    const auto pose = truth.at(observation->time_s);
    if (pose && observation->views[0].points) mapper.add(*pose, *observation->views[0].points);
  }
  return mapper.seen();
}

TEST(GridPlaceOfRealMaps, IsFoundOnDrawingsOfTheirPlace) {
  if (!exists(kData / "campus")) GTEST_SKIP() << kData << " is not there";
  const auto drawing = [](const std::string& name) { return readMap(kData / (name + ".handmap")); };
  const SeenGround campus = realMap("campus");
  expectFound(placeOf(campus, drawing("campus/truth")), 0.2, 0.2);
  expectFound(placeOf(campus, drawing("campus/sketch-b")), 6.0, 2.0);
  EXPECT_FALSE(isCertain(placeOf(campus, drawing("street/truth"))));
  const SeenGround street = realMap("street");
  expectFound(placeOf(street, drawing("street/truth")), 0.3, 0.2);
  expectFound(placeOf(street, drawing("street/sketch-a")), 3.0, 2.0);
  EXPECT_FALSE(isCertain(placeOf(street, drawing("campus/truth"))));
}

}  // namespace
}  // namespace handmap
