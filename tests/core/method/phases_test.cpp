// A step that is gone through phase by phase: what is told of it, and that looking changes nothing.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/map/map_io.h"
#include "core/method/phase.h"
#include "core/session/run_session.h"

namespace handmap {
namespace {

/// Two fronts along the way, drawn 1 m too far off.
class Fronts : public ObservationSource {
 public:
  Fronts() { info_.observations = kCount; }
  const SourceInfo& info() const override { return info_; }
  std::optional<Observation> next() override {
    if (next_ == kCount) return std::nullopt;
    Observation observation;
    observation.frame = next_;
    observation.time_s = next_;
    observation.odometry = {2.5 * next_, 0.0, 0.0};
    auto& points = observation.views.emplace_back().points.emplace();
    const auto here = static_cast<float>(observation.odometry.x);
    for (float x = 0.0F; x < 20.0F; x += 0.1F) {
      points.push_back({x - here, 8.0F, 1.0F, 1.0F});
      points.push_back({x - here, -8.0F, 1.0F, 1.0F});
    }
    ++next_;
    return observation;
  }

 private:
  static constexpr int kCount = 6;
  SourceInfo info_;
  int next_ = 0;
};

Map drawing() {
  Map map;
  map.start = Pose2{};
  Building north;
  north.id = "N";
  north.shape = Rectangle{{10.0, 14.0}, 20.0, 10.0, 0.0};
  Building south = north;
  south.id = "S";
  south.shape = Rectangle{{10.0, -14.0}, 20.0, 10.0, 0.0};
  map.buildings = {north, south};
  return map;
}

RunSettings settingsOf(Method method, int threads = 1) {
  RunSettings settings;
  settings.method = method;
  settings.slam.slam_particles = 20;
  settings.threads = threads;
  return settings;
}

std::vector<PhaseKind> kindsOf(const Snapshot& snapshot) {
  std::vector<PhaseKind> kinds;
  for (const Phase& phase : *snapshot.phases) kinds.push_back(phase.kind);
  return kinds;
}

/// Steps of a session; with phases from the third on.
std::vector<std::shared_ptr<const Snapshot>> steps(const RunSettings& settings, bool tracing) {
  RunSession session(drawing(), std::make_unique<Fronts>(), settings);
  std::vector<std::shared_ptr<const Snapshot>> snapshots;
  for (;;) {
    session.setTracing(tracing && snapshots.size() >= 2);
    auto snapshot = session.step();
    if (!snapshot) return snapshots;
    snapshots.push_back(std::move(snapshot));
  }
}

std::string bytesOf(const Snapshot& snapshot) {
  std::string bytes = formatMap(*snapshot.map) + formatTum(snapshot.trajectory.all());
  for (const ParticleView& particle : snapshot.particles) {
    bytes.append(reinterpret_cast<const char*>(&particle), sizeof particle);
  }
  return bytes;
}

TEST(Phases, OfThePublishedMethodFollowItsAlgorithm) {
  const auto snapshots = steps(settingsOf(Method::Paper), true);
  EXPECT_FALSE(snapshots[1]->phases);
  const Snapshot& snapshot = *snapshots[2];
  ASSERT_TRUE(snapshot.phases);
  const std::vector<PhaseKind> kinds = kindsOf(snapshot);
  ASSERT_GE(kinds.size(), 6U);
  EXPECT_EQ(kinds[0], PhaseKind::Prediction);
  EXPECT_EQ(kinds[1], PhaseKind::LocalMap);
  EXPECT_EQ(kinds[kinds.size() - 2], PhaseKind::Weights);
  EXPECT_EQ(kinds.back(), PhaseKind::Resampling);
  const int swarms = static_cast<int>(std::ranges::count(kinds, PhaseKind::Swarms));
  EXPECT_EQ(swarms, static_cast<int>(kinds.size()) - 4);
  const std::vector<Phase>& phases = *snapshot.phases;
  EXPECT_NEAR(phases[0].facts.moved_m, 2.5, 1.0);
  EXPECT_FALSE(phases[0].shown.local_map);
  EXPECT_TRUE(phases[1].shown.local_map);
  for (int i = 0; i < swarms; ++i) {
    const Phase& phase = phases[static_cast<std::size_t>(2 + i)];
    EXPECT_EQ(phase.facts.iteration, i);
    EXPECT_EQ(phase.facts.iterations, swarms - 1);
    EXPECT_EQ(phase.outlines.size(), 2U);
    ASSERT_EQ(phase.shown.swarms.size(), 2U);
    EXPECT_EQ(phase.shown.swarms[0].members.size(), 20U);
    if (i == 0) continue;
    EXPECT_GE(phase.facts.value, phases[static_cast<std::size_t>(1 + i)].facts.value);
  }
  EXPECT_EQ(phases.back().shown.particles.size(), snapshot.particles.size());
  for (std::size_t i = 0; i < snapshot.particles.size(); ++i) {
    EXPECT_EQ(phases.back().shown.particles[i].pose, snapshot.particles[i].pose);
  }
}

TEST(Phases, OfOursGoFromTheWayToTheCorrection) {
  const auto snapshots = steps(settingsOf(Method::Handmap), true);
  const Snapshot& snapshot = *snapshots[3];
  ASSERT_TRUE(snapshot.phases);
  const std::vector<PhaseKind> kinds = kindsOf(snapshot);
  const std::vector<PhaseKind> expected = {PhaseKind::Way,      PhaseKind::Poses,
                                           PhaseKind::Evidence, PhaseKind::Detection,
                                           PhaseKind::Labels,   PhaseKind::Correction};
  ASSERT_EQ(kinds, expected);
  const std::vector<Phase>& phases = *snapshot.phases;
  EXPECT_NEAR(phases[0].facts.moved_m, 2.5, 0.5);
  EXPECT_GE(phases[3].walls.size(), 2U);
  EXPECT_EQ(phases[3].outlines.size(), static_cast<std::size_t>(phases[3].facts.count));
  EXPECT_EQ(phases[4].links.size(), static_cast<std::size_t>(phases[4].facts.count));
  EXPECT_EQ(phases[5].shown.map->buildings, snapshot.map->buildings);
  EXPECT_EQ(phases[5].shown.report.pose, snapshot.report.pose);
  // Evidence speaks for walls where the fronts are.
  const LocalMap& evidence = phases[2].shown.local_map.get();
  EXPECT_GT(evidence.at(2.0, 8.0), 0.5F);
  EXPECT_LT(evidence.at(2.0, 0.0), 0.5F);
}

TEST(Phases, LookingChangesNothing) {
  for (const Method method : {Method::Paper, Method::Handmap}) {
    const auto plain = steps(settingsOf(method), false);
    const auto traced = steps(settingsOf(method, 3), true);
    ASSERT_EQ(plain.size(), traced.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
      EXPECT_EQ(bytesOf(*plain[i]), bytesOf(*traced[i])) << "step " << i;
    }
  }
}

TEST(Phases, AnObservationTellsHowLikelyItWas) {
  for (const Method method : {Method::Paper, Method::Handmap}) {
    const auto snapshots = steps(settingsOf(method), false);
    ASSERT_TRUE(snapshots[4]->report.log_likelihood);
    EXPECT_GT(*snapshots[4]->report.log_likelihood, 0.0);
  }
}

}  // namespace
}  // namespace handmap
