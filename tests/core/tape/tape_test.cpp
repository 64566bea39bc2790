#include "core/tape/tape.h"

#include <thread>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

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
  Tape tape(std::make_unique<Fronts>(asked), {}, {1U << 20U, 0});
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
  EXPECT_EQ(tape.odometry().size(), 5U);
}

TEST(Tape, KeepsTheNewestOfManyAndSaysWhatIsGone) {
  int asked = 0;
  Tape tape(std::make_unique<Fronts>(asked), {}, {20'000, 0});
  for (std::size_t n = 0; n < 6; ++n) tape.take(n, {});
  EXPECT_GT(tape.begin(), 0U);
  EXPECT_LT(tape.begin(), 6U);
  EXPECT_TRUE(tape.take(5, {}));
  EXPECT_THROW(tape.take(0, {}), Error);
  EXPECT_EQ(tape.odometry().size(), 5U);  // is never forgotten
}

/// An hour of a planar scanner that is driven at a metre a second.
class LongDrive : public ObservationSource {
 public:
  static constexpr int kScans = 36'000;
  LongDrive() { info_.observations = kScans; }
  const SourceInfo& info() const override { return info_; }
  std::optional<Observation> next() override {
    if (next_ == kScans) return std::nullopt;
    Observation observation;
    observation.frame = next_;
    observation.time_s = 0.1 * next_;
    observation.odometry = {0.1 * next_++, 0.0, 0.0};
    auto& points = observation.views.emplace_back().points.emplace();
    for (float x = -4.0F; x < 4.0F; x += 0.2F) points.push_back({x, 8.0F, 1.0F, 1.0F});
    return observation;
  }

 private:
  SourceInfo info_;
  int next_ = 0;
};

TEST(Tape, AnHourIsKeptInBoundedMemoryFromItsBeginning) {
  constexpr std::size_t kMemory = 8U << 20U;
  Tape tape(std::make_unique<LongDrive>(), {}, {kMemory, std::size_t{1} << 30U});
  for (std::size_t n = 0; n < LongDrive::kScans; ++n) {
    ASSERT_TRUE(tape.take(n, {}));
  }
  EXPECT_LE(tape.memory(), kMemory);
  EXPECT_GT(tape.disk(), kMemory);
  EXPECT_EQ(tape.begin(), 0U);
  for (const int n : {0, 17'000, LongDrive::kScans - 1}) {
    const auto taken = tape.take(static_cast<std::size_t>(n), {});
    ASSERT_TRUE(taken && taken->entry.perceived);
    EXPECT_EQ(taken->entry.perceived->observation.frame, n);
    EXPECT_EQ(taken->entry.perceived->percept.points.size(), 40U);
    EXPECT_FALSE(taken->entry.perceived->percept.scan.rays.empty());
  }
}

TEST(Tape, NumbersOfFollowedPointsAreKeptWithThem) {
  Perceived perceived;
  perceived.percept.points = {{8.0F, 1.0F, 2.0F, 1.0F}, {9.0F, 1.0F, 2.0F, 1.0F}};
  perceived.percept.ids = {7, 0};
  const auto again = unpacked(packed(perceived));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->percept.ids, perceived.percept.ids);
  EXPECT_EQ(again->percept.points.size(), 2U);
}

TEST(Tape, OnAFullDiskTheOldestGoes) {
  int asked = 0;
  Tape tape(std::make_unique<Fronts>(asked), {}, {0, 60'000});
  for (std::size_t n = 0; n < 6; ++n) tape.take(n, {});
  EXPECT_LE(tape.disk(), 60'000U);
  EXPECT_GT(tape.begin(), 0U);
  EXPECT_THROW(tape.take(0, {}), Error);
  EXPECT_TRUE(tape.take(4, {})->entry.perceived);
}

TEST(PastSight, AMomentLongPastIsSeenAsItWas) {
  const auto tape = std::make_shared<Tape>(std::make_unique<LongDrive>(), PerceptionOptions(),
                                           TapeLimits{0, 1U << 30U});
  LocalMapBuilder builder(tape->info().range_limit_m, {});
  LazyLocalMap direct;
  for (std::size_t n = 0; n < 50; ++n) {
    const auto perceived = tape->take(n, {})->entry.perceived;
    const auto map = builder.add(perceived->observation.odometry, false, perceived->percept.walls);
    if (n == 20) direct = map;
  }
  const PastSight sight(tape, 20);
  EXPECT_EQ(sight.lock()->observation.frame, 20);
  EXPECT_EQ(cv::countNonZero(sight.localMap().get().cells() != direct.get().cells()), 0);
  EXPECT_FALSE(PastSight().lock());
  EXPECT_FALSE(PastSight().localMap());
}

TEST(Tape, ReadersInTwoThreadsSeeTheSame) {
  int asked = 0;
  Tape tape(std::make_unique<Fronts>(asked), {}, {1U << 20U, 0});
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
  Tape tape(std::make_unique<Fronts>(asked), {}, {1U << 20U, 0});
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
  Tape tape(std::make_unique<Interrupting>(stop, is_open), {}, {1U << 20U, 0});
  EXPECT_FALSE(tape.take(0, stop.get_token()));
  EXPECT_EQ(tape.end(), 0U);
  const auto taken = tape.take(0, {});
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->entry.perceived->observation.frame, 0);
}

TEST(Tape, ClosedItLetsGoOfTheSourceAndKeepsWhatWasPerceived) {
  bool is_open = false;
  Tape tape(std::make_unique<Interrupting>(std::stop_source(), is_open), {}, {1U << 20U, 0});
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

constexpr TapeLimits kAllInMemory{1U << 30U, 0};
constexpr TapeLimits kNearlyAllOnDisk{0, 1U << 30U};

std::shared_ptr<Tape> tapeOf(const Scene& scene, const TapeLimits& limits = kAllInMemory) {
  return std::make_shared<Tape>(simulate(scene.world, {}, 7), scene.settings.perception, limits);
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
    for (const TapeLimits& limits : {kAllInMemory, kNearlyAllOnDisk}) {
      const auto tape = tapeOf(scene, limits);
      for (int i = 0; i < 2; ++i) {
        RunSession session(scene.world.map, tape, scene.settings);
        EXPECT_EQ(formatMap(ranToItsEnd(session)), expected);
        EXPECT_EQ(session.frames().size(), alone.frames().size());
      }
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

TEST(RunSession, AGivenPoseTellsWhereItStarted) {
  const World world = campusWorld(4);
  const auto scans = [&] { return simulate(world, laserOnTheMove(2.0), 4); };
  const auto truth = scans()->info().truth;
  const StampedPose& middle = truth[truth.size() / 2];
  RunSettings settings;
  settings.given_poses = {{middle.time_s, middle.pose * Pose2{0.5, -0.5, 0.05}}};
  Map drawing = world.map;
  const auto run = [&] {
    RunSession session(drawing, scans(), settings);
    while (session.step()) {
    }
    const StampedPose last = session.trajectory().back();
    EXPECT_EQ(last.time_s, truth.back().time_s);
    const Map refined = session.refinedMap();
    EXPECT_TRUE(refined.start_uncertainty);
    EXPECT_LT(between(*refined.start, *world.map.start).position().norm(), 4.0);
    const auto warnings = session.warnings();
    const bool moved = std::any_of(warnings.begin(), warnings.end(),
                                   [](const RunWarning& w) { return w.code == "start_moved"; });
    const bool was_off = !(*drawing.start == *world.map.start);
    EXPECT_EQ(moved, was_off);
    return between(last.pose, truth.back().pose).position().norm();
  };
  EXPECT_LT(run(), 3.0) << "a right start and a right pose";
  drawing.start = Pose2{20.0, 10.0, 0.0} * *drawing.start;
  EXPECT_LT(run(), 8.0) << "a start that is 22 m off";
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
