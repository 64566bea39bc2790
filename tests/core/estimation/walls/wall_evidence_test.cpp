#include "core/estimation/walls/wall_evidence.h"

#include <array>

#include <gtest/gtest.h>

#include "core/estimation/walls/wall_detection.h"
#include "tests/core/estimation/scene.h"

namespace handmap {
namespace {

constexpr double kEvidenceCell = 0.25;
constexpr double kWindow = 160.0;

/// The sum over the rays that cross the wall from below, the plain way.
double plainEvidence(const Frame& frame, double from_x, double to_x, double y,
                     const SensorModel& sensor) {
  double sum = 0.0;
  for (const FrameRay& ray : frame.rays) {
    const Vec2 direction = unitVector(frame.pose.heading + static_cast<double>(ray.bearing));
    if (direction.y() < 0.05) continue;
    const double distance = (y - frame.pose.y) / direction.y();
    const double x = frame.pose.x + distance * direction.x();
    if (distance < 0.0 || x < from_x || x >= to_x) continue;
    sum += static_cast<double>(sensor(ray.sight, static_cast<float>(distance),
                                      static_cast<float>(0.5 * kEvidenceCell / direction.y())));
  }
  return sum;
}

TEST(WallImage, IsTheSumOverTheRaysThatCross) {
  RandomStream random(3);
  const auto sensor = std::make_shared<const SensorModel>(MeasuredSensor{}, 40.0);
  for (int round = 0; round < 10; ++round) {
    const Box box = boxOf({{random.uniform(-5.0, 5.0), 20.0}, 20.0, 8.0, 0.0});
    const Pose2 pose{random.uniform(-8.0, 8.0), random.uniform(0.0, 6.0),
                     random.uniform(-3.0, 3.0)};
    Frame frame = seenFrom(pose, {box}, 0.2, random);
    WallImage image(0.0, kEvidenceCell, kWindow);
    image.apply({&frame, pose, sensor}, 1);
    for (int row = 40; row < 90; row += 7) {
      const int from = -30;
      const int to = 25;
      double sum = 0.0;
      for (int column = from; column < to; ++column) sum += image.at(column, row);
      const double plain = plainEvidence(frame, from * kEvidenceCell, to * kEvidenceCell,
                                         (row + 0.5) * kEvidenceCell, *sensor);
      EXPECT_NEAR(sum, plain, 0.01 * std::abs(plain) + 1.0) << row;
    }
  }
}

TEST(WallEvidence, PutInAnewItIsAsItWasOneByOne) {
  RandomStream random(6);
  const auto sensor = std::make_shared<const SensorModel>(MeasuredSensor{}, 40.0);
  const Box box = boxOf({{0.0, 15.0}, 20.0, 8.0, 0.2});
  WallEvidence evidence(kEvidenceCell, kWindow);
  evidence.include(0.1, {});
  std::vector<Frame> frames;
  for (double x = -4.0; x <= 4.0; x += 2.0) {
    frames.push_back(seenFrom({x, 0.0, 0.1}, {box}, 0.2, random));
  }
  std::vector<ActiveFrame> held;
  for (Frame& frame : frames) {
    held.push_back({&frame, frame.pose, sensor});
    evidence.add(held.back());
  }
  const auto cells = [&] {
    std::vector<double> all;
    for (const WallImage& image : evidence.images()) {
      for (int column = 0; column < image.size(); ++column) {
        for (int row = 0; row < image.size(); ++row) all.push_back(image.at(column, row));
      }
    }
    return all;
  };
  const std::vector<double> one_by_one = cells();
  evidence.add({&frames.front(), {7.0, -3.0, 1.0}, sensor});
  EXPECT_NE(cells(), one_by_one);
  evidence.putAnew(held);
  EXPECT_EQ(cells(), one_by_one);
}

TEST(WallEvidence, SomeChangedForOthersItIsAsIfThoseHadBeenAddedAlone) {
  RandomStream random(8);
  const auto sensor = std::make_shared<const SensorModel>(MeasuredSensor{}, 40.0);
  Frame frame = seenFrom({1.0, 2.0, 0.3}, {boxOf({{0.0, 15.0}, 20.0, 8.0, 0.2})}, 0.2, random);
  const std::vector<ActiveFrame> before{{&frame, frame.pose, sensor}, {&frame, {2.0, 1.0}, sensor}};
  const std::vector<ActiveFrame> after{{&frame, {1.5, 2.0, 0.2}, sensor}};
  WallEvidence changed(kEvidenceCell, kWindow);
  changed.include(0.1, before);
  changed.change(before, after);
  WallEvidence alone(kEvidenceCell, kWindow);
  alone.include(0.1, after);
  for (int column = 0; column < alone.images()[0].size(); ++column) {
    for (int row = 0; row < alone.images()[0].size(); ++row) {
      ASSERT_EQ(changed.images()[0].at(column, row), alone.images()[0].at(column, row));
    }
  }
}

TEST(WallImage, CellsOfAColumnAreOneBehindTheOtherWhereThePlaneIsWrappedAround) {
  RandomStream random(9);
  const auto sensor = std::make_shared<const SensorModel>(MeasuredSensor{}, 40.0);
  Frame frame = seenFrom({0.0, -20.0, 0.0}, {boxOf({{0.0, 4.0}, 40.0, 8.0, 0.0})}, 0.2, random);
  WallImage image(0.0, kEvidenceCell, kWindow);
  image.apply({&frame, frame.pose, sensor}, 1);
  std::array<std::int32_t, 40> wrapped{};
  for (const int first : {-60, -20, -1, 3}) {
    const std::int32_t* cells = image.cells(-7, first, wrapped);
    for (int i = 0; i < 40; ++i) {
      EXPECT_EQ(cells[i] / walls::kScale, image.at(-7, first + i)) << first << ' ' << i;
    }
  }
}

TEST(WallEvidence, AFrameTakenOutLeavesNoTrace) {
  RandomStream random(4);
  const auto sensor = std::make_shared<const SensorModel>(MeasuredSensor{}, 40.0);
  const Box box = boxOf({{0.0, 15.0}, 20.0, 8.0, 0.2});
  WallEvidence evidence(kEvidenceCell, kWindow);
  evidence.include(0.1, {});
  Frame frame = seenFrom({1.0, 2.0, 0.3}, {box}, 0.2, random);
  const ActiveFrame held{&frame, frame.pose, sensor};
  evidence.add(held);
  evidence.remove(held);
  for (const WallImage& image : evidence.images()) {
    for (int column = 0; column < image.size(); ++column) {
      for (int row = 0; row < image.size(); ++row) ASSERT_EQ(image.at(column, row), 0.0);
    }
  }
}

TEST(WallEvidence, ADirectionTakenUpLaterHoldsTheSame) {
  RandomStream random(6);
  const auto sensor = std::make_shared<const SensorModel>(MeasuredSensor{}, 40.0);
  const Box box = boxOf({{0.0, 15.0}, 20.0, 8.0, 0.2});
  Frame frame = seenFrom({1.0, 2.0, 0.3}, {box}, 0.2, random);
  WallEvidence first(kEvidenceCell, kWindow);
  first.include(0.2, {});
  const ActiveFrame held{&frame, frame.pose, sensor};
  first.add(held);
  WallEvidence later(kEvidenceCell, kWindow);
  later.include(0.7, {});
  later.include(0.2, {&held, 1});
  later.exclude(0.7);
  ASSERT_EQ(later.images().size(), 4u);
  for (int column = 0; column < first.images()[0].size(); ++column) {
    for (int row = 0; row < first.images()[0].size(); ++row) {
      ASSERT_EQ(first.images()[0].at(column, row), later.images()[0].at(column, row));
    }
  }
}

TEST(DetectWalls, NeighboursWithAGapAreTwoWalls) {
  RandomStream random(5);
  const auto sensor = std::make_shared<const SensorModel>(MeasuredSensor{}, 40.0);
  const std::vector<Box> boxes{boxOf({{-15.0, 15.0}, 20.0, 8.0, toRadians(3.0)}),
                               boxOf({{15.0, 15.0}, 24.0, 8.0, 0.0})};
  WallEvidence evidence(kEvidenceCell, kWindow);
  evidence.include(0.0, {});
  for (double x = -20.0; x <= 20.0; x += 5.0) {
    Frame frame = seenFrom({x, 0.0, 0.0}, boxes, 0.2, random);
    evidence.add({&frame, frame.pose, sensor});
  }
  const auto walls = detectWalls(evidence, Vec2::Zero(), 40.0);
  ASSERT_GE(walls.size(), 2u);
  EXPECT_LT(walls[0].a.x() * walls[1].a.x(), 0.0);
  for (const FoundWall& wall : {walls[0], walls[1]}) {
    const Rectangle front = boxes[wall.a.x() < 0.0 ? 0 : 1].rectangle();
    EXPECT_NEAR(wall.length(), front.width, 1.0);
    EXPECT_NEAR(wall.heading(), front.heading, toRadians(1.6));
  }
}

}  // namespace
}  // namespace handmap
