#include "core/session/tape.h"

#include <thread>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/session/run_session.h"
#include "core/simulation/simulated_source.h"

namespace handmap {
namespace {

/// Planar fronts; frame 2 cannot be read. Counts how often it is asked.
class Fronts : public ObservationSource {
 public:
  explicit Fronts(int& asked) : asked_(asked) { info_.observations = 6; }
  const SourceInfo& info() const override { return info_; }
  std::optional<Observation> next() override {
    ++asked_;
    if (next_ == info_.observations) return std::nullopt;
    const int frame = next_++;
    if (frame == 2) throw FrameError(frame, "broken");
    Observation observation;
    observation.frame = frame;
    observation.time_s = frame;
    observation.odometry = {2.0 * frame, 0.0, 0.0};
    auto& points = observation.views.emplace_back().points.emplace();
    for (float x = -20.0F; x < 20.0F; x += 0.1F) points.push_back({x, 8.0F, 1.0F, 1.0F});
    return observation;
  }

 private:
  SourceInfo info_;
  int& asked_;
  int next_ = 0;
};

TEST(Tape, AsksTheSourceOnce) {
  int asked = 0;
  Tape tape(std::make_unique<Fronts>(asked), {}, 1U << 20U);
  for (int round = 0; round < 3; ++round) {
    for (std::size_t n = 0; n < 6; ++n) {
      const auto taken = tape.take(n, {});
      ASSERT_TRUE(taken);
      EXPECT_EQ(taken->from_now, round == 0);
      if (n == 2) {
        EXPECT_FALSE(taken->entry.perceived);
        EXPECT_EQ(taken->entry.skipped->reason, "broken");
      } else {
        EXPECT_EQ(taken->entry.perceived->observation.frame, static_cast<int>(n));
        EXPECT_EQ(taken->entry.perceived->percept.points.size(), 400U);
      }
    }
  }
  EXPECT_EQ(asked, 6);
  EXPECT_EQ(tape.end(), 6U);
  EXPECT_FALSE(tape.take(6, {}));
  EXPECT_EQ(tape.all().size(), 5U);
  EXPECT_EQ(tape.odometry().size(), 5U);
}

TEST(Tape, KeepsTheNewestOfManyAndSaysWhatIsGone) {
  int asked = 0;
  Tape tape(std::make_unique<Fronts>(asked), {}, 40'000);
  for (std::size_t n = 0; n < 6; ++n) tape.take(n, {});
  EXPECT_GT(tape.begin(), 0U);
  EXPECT_LT(tape.begin(), 6U);
  EXPECT_TRUE(tape.take(5, {}));
  EXPECT_THROW(tape.take(0, {}), Error);
  EXPECT_EQ(tape.odometry().size(), 5U);  // is never forgotten
}

TEST(Tape, ReadersInTwoThreadsSeeTheSame) {
  int asked = 0;
  Tape tape(std::make_unique<Fronts>(asked), {}, 1U << 20U);
  std::vector<const Perceived*> seen[2];
  {
    const auto read = [&tape](std::vector<const Perceived*>& seen_by) {
      for (std::size_t n = 0; n < 6; ++n)
        seen_by.push_back(tape.take(n, {})->entry.perceived.get());
    };
    const std::jthread one(read, std::ref(seen[0]));
    const std::jthread other(read, std::ref(seen[1]));
  }
  EXPECT_EQ(seen[0], seen[1]);
  EXPECT_EQ(asked, 6);
}

TEST(Tape, AStopIsNotTheEnd) {
  int asked = 0;
  Tape tape(std::make_unique<Fronts>(asked), {}, 1U << 20U);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(tape.take(0, stop.get_token()));
  EXPECT_TRUE(tape.take(0, {}));
}

/// A source that asks for the stop while it is read, and says when it goes.
class Interrupting : public ObservationSource {
 public:
  Interrupting(std::stop_source stop, bool& is_open) : stop_(std::move(stop)), is_open_(is_open) {
    is_open_ = true;
  }
  ~Interrupting() override { is_open_ = false; }
  const SourceInfo& info() const override { return fronts_.info(); }
  std::optional<Observation> next() override {
    stop_.request_stop();
    return fronts_.next();
  }

 private:
  int asked_ = 0;
  Fronts fronts_{asked_};
  std::stop_source stop_;
  bool& is_open_;
};

TEST(Tape, WhatWasInterruptedIsThereForWhoTakesItNext) {
  std::stop_source stop;
  bool is_open = false;
  Tape tape(std::make_unique<Interrupting>(stop, is_open), {}, 1U << 20U);
  EXPECT_FALSE(tape.take(0, stop.get_token()));
  EXPECT_EQ(tape.end(), 0U);
  const auto taken = tape.take(0, {});
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->entry.perceived->observation.frame, 0);
}

TEST(Tape, ClosedItLetsGoOfTheSourceAndKeepsWhatWasPerceived) {
  bool is_open = false;
  Tape tape(std::make_unique<Interrupting>(std::stop_source(), is_open), {}, 1U << 20U);
  EXPECT_TRUE(tape.take(0, {}));
  EXPECT_TRUE(is_open);
  tape.close();
  EXPECT_FALSE(is_open);
  EXPECT_TRUE(tape.take(0, {}));
  EXPECT_FALSE(tape.take(1, {}));
  EXPECT_EQ(tape.info().observations, 6);
  tape.close();
}

struct Scene {
  World world = twoRowWorld(7);
  RunSettings settings;
};

std::shared_ptr<Tape> tapeOf(const Scene& scene) {
  return std::make_shared<Tape>(simulate(scene.world, {}, 7), scene.settings.perception, 1U << 30U);
}

Map ranToItsEnd(RunSession& session) {
  while (session.step()) {
  }
  return session.refinedMap();
}

TEST(Tape, ARunFromItIsTheSameRun) {
  for (const Method method : {Method::Handmap, Method::Paper}) {
    Scene scene;
    scene.settings.method = method;
    scene.settings.slam.slam_particles = 10;
    RunSession alone(scene.world.map, simulate(scene.world, {}, 7), scene.settings);
    const std::string expected = formatMap(ranToItsEnd(alone));
    const auto tape = tapeOf(scene);
    for (int i = 0; i < 2; ++i) {
      RunSession session(scene.world.map, tape, scene.settings);
      EXPECT_EQ(formatMap(ranToItsEnd(session)), expected);
      EXPECT_EQ(session.frames().size(), alone.frames().size());
    }
  }
}

TEST(RunSession, IsLedBackByAGivenPose) {
  Scene scene;
  const auto tape = tapeOf(scene);
  Map lost = scene.world.map;
  lost.start = *lost.start * Pose2{6.0, 3.0, 0.3};
  const auto error = [&](const RunSettings& settings) {
    RunSession session(lost, tape, settings);
    double sum = 0.0;
    int count = 0;
    while (const auto snapshot = session.step()) {
      if (++count < 4) continue;
      sum += (snapshot->report.pose.position() - snapshot->truth->position()).norm();
    }
    return sum / count;
  };
  scene.settings.method = Method::Paper;
  scene.settings.slam.refine = false;
  const double without = error(scene.settings);
  const auto truth = tape->info().truth;
  for (const std::size_t i : {1U, 3U}) scene.settings.given_poses.push_back(truth.at(i));
  EXPECT_LT(error(scene.settings), 0.7 * without);
}

TEST(Tape, AnotherDrawingMayTakeOverInTheMiddle) {
  Scene scene;
  Map changed = scene.world.map;
  changed.buildings.pop_back();
  RunSession alone(changed, simulate(scene.world, {}, 7), scene.settings);
  const std::string expected = formatMap(ranToItsEnd(alone));
  const auto tape = tapeOf(scene);
  {
    RunSession before(scene.world.map, tape, scene.settings);
    for (int i = 0; i < 5; ++i) before.step();
  }
  EXPECT_EQ(tape->end(), 5U);
  RunSession session(changed, tape, scene.settings);
  EXPECT_EQ(formatMap(ranToItsEnd(session)), expected);
}

}  // namespace
}  // namespace handmap
