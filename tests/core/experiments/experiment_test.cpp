// Experiments of real trials, small ones: resumed, divided, and put together again.
#include "core/experiments/experiment.h"

#include <gtest/gtest.h>

#include "core/experiments/report.h"
#include "core/experiments/trial_table.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/experiments/made_trial.h"

namespace handmap {
namespace {

using test::expectBadInput;
using test::TemporaryFolder;

Experiment small() {
  Experiment experiment;
  experiment.sigmas_m = {5.0, 1.0};
  experiment.methods = {Method::Paper};
  experiment.trials = 2;
  experiment.settings.seed = 40;
  experiment.settings.slam_particles = 4;
  experiment.settings.pso_particles = 4;
  return experiment;
}

int run(const Experiment& experiment, const TemporaryFolder& folder, const Shard& shard = {},
        int threads = 2) {
  return runTrials(experiment, shard, folder.path(), threads, {});
}

TEST(Experiment, NamesItsTrialsOnce) {
  Experiment experiment = small();
  experiment.sigmas_m = {5.0, 1.0, 5.0};
  experiment.methods = {Method::Paper, Method::Handmap, Method::Paper};
  const std::vector<TrialKey> keys = trialsOf(experiment);
  ASSERT_EQ(keys.size(), 8U);
  EXPECT_EQ(keys.front(), (TrialKey{Method::Handmap, 1.0, 0}));
  EXPECT_EQ(keys.back(), (TrialKey{Method::Paper, 5.0, 1}));
}

TEST(Experiment, TrialsTellTheRunAndFollowFromTheSeed) {
  const TrialSettings settings = small().settings;
  const Trial trial = runTrial({Method::Handmap, 5.0, 0}, settings, {}).value();
  EXPECT_TRUE(trial.loose());
  ASSERT_GT(trial.way.size(), 20U);
  EXPECT_EQ(trial.way.front().odometry, 0.0);
  EXPECT_GT(trial.way.back().odometry, trial.way.back().pose);
  EXPECT_LT(trial.way.back().map, trial.way.front().map / 2.0);
  EXPECT_EQ(trialLine(runTrial(trial.key, settings, {}).value()), trialLine(trial));
  // Methods are compared on the same drawings and drives.
  const Trial paper = runTrial({Method::Paper, 5.0, 0}, settings, {}).value();
  EXPECT_EQ(paper.way.back().odometry, trial.way.back().odometry);
  EXPECT_EQ(paper.buildings[3].drawn, trial.buildings[3].drawn);
  const Trial next = runTrial({Method::Paper, 5.0, 1}, settings, {}).value();
  EXPECT_NE(next.buildings[3].drawn, paper.buildings[3].drawn);
}

TEST(Trial, DepthsDrawnManyTimesTooGreatAreFound) {
  TrialSettings settings;
  settings.seed = 7100;
  for (const int number : {3, 29, 63}) {
    EXPECT_TRUE(runTrial({Method::Handmap, 33.0, number}, settings, {}).value().strict()) << number;
  }
}

TEST(Experiment, IsTheSameOnAnyNumberOfThreads) {
  const TemporaryFolder one;
  const TemporaryFolder three;
  EXPECT_EQ(run(small(), one, {}, 1), 4);
  EXPECT_EQ(run(small(), three, {}, 3), 4);
  EXPECT_GT(one.read("trials-1-of-1.csv").size(), 2000U);
  EXPECT_EQ(one.read("trials-1-of-1.csv"), three.read("trials-1-of-1.csv"));
}

TEST(Experiment, ShardsPutTogetherEqualOneRun) {
  const TemporaryFolder whole;
  const TemporaryFolder shards;
  const TrialSettings settings = small().settings;
  EXPECT_EQ(run(small(), whole), 4);
  EXPECT_EQ(run(small(), shards, {3, 3}), 1);
  EXPECT_EQ(run(small(), shards, {1, 3}), 2);
  EXPECT_EQ(readTrials(shards.path(), settings).size(), 3U);
  EXPECT_EQ(run(small(), shards, {2, 3}), 1);
  EXPECT_EQ(run(small(), shards), 0) << "all are there";
  for (const ExperimentKind kind :
       {ExperimentKind::Table2, ExperimentKind::Figure8, ExperimentKind::Way}) {
    Experiment experiment = small();
    experiment.kind = kind;
    const Report report = reportOf(experiment, readTrials(whole.path(), settings));
    writeReport(report, whole.path());
    writeReport(reportOf(experiment, readTrials(shards.path(), settings)), shards.path());
    ASSERT_GE(report.charts.size(), 2U);
    for (const auto& [name, chart] : report.charts) {
      EXPECT_EQ(whole.read(name).substr(1, 3), "PNG");
      EXPECT_EQ(whole.read(name), shards.read(name)) << name;
    }
    for (const char* name : {"report.md", "report.csv"}) {
      EXPECT_GT(whole.read(name).size(), 100U);
      EXPECT_EQ(whole.read(name), shards.read(name)) << name;
    }
  }
}

TEST(Experiment, ResumesWhereItWasKilled) {
  const TemporaryFolder folder;
  Experiment experiment = small();
  EXPECT_EQ(run(experiment, folder), 4);
  const std::string whole = folder.read("trials-1-of-1.csv");
  folder.write("trials-1-of-1.csv", whole.substr(0, whole.size() - 50));  // within the last line
  EXPECT_EQ(run(experiment, folder), 1);
  EXPECT_EQ(folder.read("trials-1-of-1.csv"), whole);
  folder.write("trials-1-of-1.csv", whole.substr(0, 30));  // within the head
  EXPECT_EQ(run(experiment, folder), 4);
  EXPECT_EQ(folder.read("trials-1-of-1.csv"), whole);
  experiment.trials = 3;
  EXPECT_EQ(run(experiment, folder), 2);
  EXPECT_EQ(folder.read("trials-1-of-1.csv").substr(0, whole.size()), whole);
}

TEST(Experiment, StopsWhenAsked) {
  const TemporaryFolder folder;
  std::stop_source stop;
  const int done = runTrials(small(), {}, folder.path(), 1, stop.get_token(),
                             [&](int, int) { stop.request_stop(); });
  EXPECT_EQ(done, 1);
  EXPECT_EQ(run(small(), folder), 3);
}

TEST(Experiment, RefusesOtherSettingsAndLeavesTheFolder) {
  const TemporaryFolder folder;
  Experiment experiment = small();
  experiment.trials = 1;
  EXPECT_EQ(run(experiment, folder, {1, 2}), 1);
  experiment.settings.pso_particles = 5;
  expectBadInput(
      [&] {
        run(experiment, folder, {2, 2});
      },
      {"trials-1-of-2.csv: line 1: pso_particles: found 4, expected 5"});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "trials-2-of-2.csv"));
}

TEST(TrialFolder, RefusesATrialThatCameOutDifferently) {
  const TemporaryFolder folder;
  const TrialKey key{Method::Paper, 5.0, 3};
  const std::string head = trialTableHead({});
  const std::string line = trialLine(test::madeTrial(key, 0.9));
  folder.write("trials-1-of-2.csv", head + line);
  folder.write("trials-1-of-3.csv", head + line);
  EXPECT_EQ(readTrials(folder.path(), {}).size(), 1U);
  folder.write("trials-1-of-3.csv", head + trialLine(test::madeTrial(key, 0.8)));
  expectBadInput([&] { readTrials(folder.path(), {}); },
                 {"trials-1-of-3.csv", "trial 3 of paper at 5 m again"});
}

TEST(TrialFolder, IsWrittenByOneProcessATable) {
  const TemporaryFolder folder;
  const TrialWriter first(folder.path(), {1, 2}, {});
  const TrialWriter other(folder.path(), {2, 2}, {});
  test::expectError(ErrorCode::RunFailed,
                    [&] {
                      TrialWriter(folder.path(), {1, 2}, {});
                    },
                    {"trials-1-of-2.csv: another process writes it"});
}

TEST(Experiment, TakesDrawingsLikeThoseOfPeople) {
  TrialSettings settings;
  const TrialScene plain = sceneOf({Method::Handmap, 10.0, 3}, settings);
  settings.like = Like::People;
  const TrialScene people = sceneOf({Method::Handmap, 10.0, 3}, settings);
  ASSERT_EQ(people.drawing.buildings.size(), Trial::kBuildings.size());
  EXPECT_NE(people.drawing.buildings, plain.drawing.buildings);
  EXPECT_NEAR(people.drawing.uncertainty.position, 10.0, 1e-9);
  // They do not mix with others in a folder.
  const TemporaryFolder folder;
  Experiment experiment = small();
  experiment.sigmas_m = {1.0};
  experiment.trials = 1;
  run(experiment, folder);
  experiment.settings.like = Like::People;
  expectBadInput([&] { readTrials(folder.path(), experiment.settings); },
                 {"line 1: drawings_like: found nothing, expected \"people\""});
  const TemporaryFolder of_people;
  TrialWriter(of_people.path(), {}, experiment.settings);
  expectBadInput([&] { readTrials(of_people.path(), small().settings); },
                 {"line 1: drawings_like: found \"people\", expected nothing"});
}

}  // namespace
}  // namespace handmap
