#include "core/estimation/buildings/box_score.h"

#include <gtest/gtest.h>

#include "tests/core/estimation/scene.h"

namespace handmap {
namespace {

double plainScore(const Box& box, const std::vector<const Frame*>& frames,
                  const SensorModel& sensor) {
  double score = 0.0;
  for (const Frame* frame : frames) {
    for (const FrameRay& ray : frame->rays) {
      const Vec2 direction = unitVector(frame->pose.heading + static_cast<double>(ray.bearing));
      const double distance = plainDistance(box, frame->pose.position(), direction);
      if (distance < 0.0) continue;
      double cosine = 0.0;
      const Vec2 hit = frame->pose.position() + distance * direction;
      for (std::size_t k = 0; k < 4; ++k) {
        const Segment wall{box.corner((k + 3) % 4), box.corner(k)};
        if (distanceTo(wall, hit) < 1e-6) cosine = std::abs(box.normal(k).dot(direction));
      }
      score += static_cast<double>(sensor(
          ray.sight, static_cast<float>(distance),
          buildings::kWallSlack_m / std::max(static_cast<float>(cosine), buildings::kLeastCosine)));
    }
  }
  return score;
}

TEST(BoxScorer, IsTheSumOverAllRays) {
  RandomStream random(7);
  const SensorModel sensor(MeasuredSensor{}, 40.0);
  for (int round = 0; round < 20; ++round) {
    const Box box = boxOf({{random.uniform(-5.0, 5.0), random.uniform(12.0, 20.0)},
                           random.uniform(5.0, 40.0),
                           random.uniform(4.0, 10.0),
                           random.uniform(-0.5, 0.5)});
    std::vector<Frame> frames;
    for (double x = -20.0; x <= 20.0; x += 5.0) {
      frames.push_back(
          seenFrom({x, random.uniform(-3.0, 1.0), random.uniform(-3.0, 3.0)}, {box}, 0.2, random));
    }
    std::vector<const Frame*> seen;
    for (const Frame& frame : frames) seen.push_back(&frame);
    BoxScorer scorer(box, seen, sensor, 1);
    const double unchanged = scorer(box);
    for (int change = 0; change < 5; ++change) {
      Box changed = box;
      changed.heading += random.normal(0.0, 0.03);
      for (double& reach : changed.reach) reach += random.normal(0.0, 0.5);
      const double plain = plainScore(changed, seen, sensor);
      EXPECT_NEAR(scorer(changed), plain, 0.01 * std::abs(plain) + 8.0);
      EXPECT_EQ(scorer(box), unchanged) << "turned back";
    }
  }
}

TEST(BoxScorer, TheTrueBoxIsBest) {
  RandomStream random(8);
  const SensorModel sensor(MeasuredSensor{}, 40.0);
  const Box box = boxOf({{0.0, 15.0}, 20.0, 8.0, 0.1});
  std::vector<Frame> frames;
  for (double x = -20.0; x <= 20.0; x += 5.0) {
    frames.push_back(seenFrom({x, 0.0, 0.0}, {box}, 0.2, random));
  }
  std::vector<const Frame*> seen;
  for (const Frame& frame : frames) seen.push_back(&frame);
  BoxScorer scorer(box, seen, sensor);
  const double best = scorer(box);
  for (std::size_t k = 0; k < 4; ++k) {
    if (k == 1) continue;  // nobody sees the rear wall
    for (const double by : {-1.0, 1.0}) {
      Box changed = box;
      changed.reach[k] += by;
      EXPECT_LT(scorer(changed), best) << k << " " << by;
    }
  }
}

TEST(BoxScorer, ARobotInsideIsImpossible) {
  RandomStream random(9);
  const SensorModel sensor(MeasuredSensor{}, 40.0);
  const Frame frame = seenFrom({}, {}, 0.2, random);
  const std::vector<const Frame*> seen{&frame};
  const Box box = boxOf({{0.0, 0.0}, 10.0, 10.0, 0.0});
  EXPECT_LT(BoxScorer(box, seen, sensor)(box), -1e5);
}

}  // namespace
}  // namespace handmap
