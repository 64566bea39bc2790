#include "widgets/run/worker/run_worker.h"

#include <QStringList>
#include <QTest>
#include <future>

#include <gtest/gtest.h>

#include "core/map/map_io.h"
#include "core/method/phase.h"
#include "core/simulation/simulated_source.h"
#include "widgets/background/background.h"

namespace handmap {
namespace {

constexpr int kWorkerPatienceMs = 60'000;

/// The first observations of another source; the second of them cannot be read if so wished.
class Shortened : public ObservationSource {
 public:
  Shortened(std::unique_ptr<ObservationSource> source, int count, bool with_gap)
      : source_(std::move(source)), info_(source_->info()), with_gap_(with_gap) {
    info_.observations = count;
  }
  const SourceInfo& info() const override { return info_; }
  std::optional<Observation> next() override {
    if (given_ == info_.observations) return std::nullopt;
    auto observation = source_->next();
    if (++given_ == 2 && with_gap_) throw FrameError(observation->frame, "torn");
    return observation;
  }

 private:
  std::unique_ptr<ObservationSource> source_;
  SourceInfo info_;
  bool with_gap_;
  int given_ = 0;
};

RunJob jobOf(int observations, int slam_particles, bool with_gap = false) {
  const World world = twoRowWorld(1);
  RunJob job;
  job.drawing = perturbed(world.map, 2.0, 1);
  job.settings.method = Method::Paper;  // its steps can be made as long as one wants
  job.settings.slam.slam_particles = slam_particles;
  job.settings.slam.pso_particles = 5;
  job.settings.slam.pso_iterations = 2;
  job.feed = std::make_shared<RunFeed>(
      [world, observations, with_gap](const std::stop_token&, const std::function<void(double)>&) {
        return std::make_unique<Shortened>(simulate(world, {}, 1), observations, with_gap);
      },
      job.settings.perception);
  return job;
}

/// A step that goes on until it is cancelled, for all that a test can tell.
RunJob endlessJob() {
  RunJob job = jobOf(3, 100'000);
  job.settings.slam.pso_particles = 100;
  job.settings.slam.pso_iterations = 100;
  return job;
}

/// A worker and all it says, in the order in which it is heard.
class Heard {
 public:
  explicit Heard(RunJob job) : worker_(std::make_unique<RunWorker>(std::move(job))) {
    RunWorker* worker = worker_.get();
    const auto note = [this](const char* event) {
      return [this, event] { events_ << QLatin1String(event); };
    };
    QObject::connect(worker, &RunWorker::started, worker, note("started"));
    QObject::connect(worker, &RunWorker::paused, worker, note("paused"));
    QObject::connect(worker, &RunWorker::resumed, worker, note("resumed"));
    QObject::connect(worker, &RunWorker::progressed, worker, [this] { ++progressed_; });
    QObject::connect(worker, &RunWorker::frameSkipped, worker, note("skipped"));
    QObject::connect(worker, &RunWorker::finished, worker,
                     [this](bool cancelled) { events_ << (cancelled ? "cancelled" : "finished"); });
    QObject::connect(worker, &RunWorker::failed, worker, [this](const Failure& failure) {
      failure_ = failure;
      events_ << "failed";
    });
    QObject::connect(&worker->mailbox(), &RunMailbox::arrived, worker, [this](const RunNews& news) {
      reports_ += static_cast<int>(news.reports.size());
      events_ << QStringLiteral("#%1").arg(news.newest->index);
    });
  }

  RunWorker& worker() { return *worker_; }
  void destroyWorker() { worker_.reset(); }
  const QStringList& events() const { return events_; }
  const Failure& failure() const { return failure_; }
  int reports() const { return reports_; }
  bool wait(const QString& event) {
    return QTest::qWaitFor([&] { return !events_.isEmpty() && events_.back() == event; },
                           kWorkerPatienceMs);
  }
  bool waitForProgress() {
    return QTest::qWaitFor([this] { return progressed_ > 0; }, kWorkerPatienceMs);
  }

 private:
  std::unique_ptr<RunWorker> worker_;
  QStringList events_;
  Failure failure_;
  int progressed_ = 0;
  int reports_ = 0;
};

TEST(RunWorker, RunsToTheEndAndShowsTheLastSnapshotBeforeItSaysSo) {
  Heard heard(jobOf(4, 10));
  heard.worker().start();
  ASSERT_TRUE(heard.wait("finished"));
  EXPECT_EQ(heard.events().front(), "started");
  EXPECT_EQ(heard.events().at(heard.events().size() - 2), "#4");
  EXPECT_EQ(heard.reports(), 4);
  ASSERT_NE(heard.worker().result(), nullptr);
  EXPECT_FALSE(heard.worker().result()->map().refinement.empty());
  EXPECT_EQ(heard.worker().result()->last->trajectory.size(), 4U);
}

TEST(RunWorker, GivesTheSameMapAsARunWithoutAThread) {
  const RunJob job = jobOf(3, 10);
  RunSession session(job.drawing, job.feed->open({}), job.settings);
  while (session.step()) {
  }
  Heard heard(job);
  heard.worker().start();
  ASSERT_TRUE(heard.wait("finished"));
  EXPECT_EQ(formatMap(heard.worker().result()->map()), formatMap(session.refinedMap()));
}

TEST(RunWorker, StepsOneByOne) {
  Heard heard(jobOf(2, 10));
  heard.worker().step();
  heard.worker().start();
  ASSERT_TRUE(heard.wait("paused"));
  EXPECT_EQ(heard.events(), (QStringList{"started", "#1", "paused"}));
  heard.worker().step();
  ASSERT_TRUE(QTest::qWaitFor([&] { return heard.events().size() == 6; }, kWorkerPatienceMs));
  EXPECT_EQ(heard.events().mid(3), (QStringList{"resumed", "#2", "paused"}));
  heard.worker().resume();
  ASSERT_TRUE(heard.wait("finished"));
}

TEST(RunWorker, AStepTellsItsPhasesWhereThatIsWanted) {
  Heard heard(jobOf(3, 10));
  heard.worker().stepPhases();
  heard.worker().start();
  ASSERT_TRUE(heard.wait("paused"));
  const auto first = heard.worker().result()->last;
  ASSERT_TRUE(first->phases);
  EXPECT_GE(first->phases->size(), 5U);
  EXPECT_EQ(heard.worker().history()->at(1)->phases, first->phases);
  heard.worker().step();
  ASSERT_TRUE(QTest::qWaitFor([&] { return heard.events().contains("#2"); }, kWorkerPatienceMs));
  EXPECT_FALSE(heard.worker().result()->last->phases);
  heard.worker().stepPhases();
  ASSERT_TRUE(QTest::qWaitFor([&] { return heard.events().contains("#3"); }, kWorkerPatienceMs));
  EXPECT_TRUE(heard.worker().result()->last->phases);
}

TEST(RunWorker, PausesInTheMiddleOfAStepAndStandsStill) {
  Heard heard(endlessJob());
  heard.worker().start();
  ASSERT_TRUE(heard.waitForProgress());
  heard.worker().pause();
  ASSERT_TRUE(heard.wait("paused"));
  EXPECT_EQ(heard.events(), (QStringList{"started", "paused"}));
  heard.worker().resume();
  ASSERT_TRUE(heard.wait("resumed"));
  heard.worker().pause();
  ASSERT_TRUE(heard.wait("paused"));
  heard.worker().cancel();
  ASSERT_TRUE(heard.wait("cancelled"));
  EXPECT_EQ(heard.worker().result(), nullptr);
}

TEST(RunWorker, CancelIsAnsweredInsideAStep) {
  Heard heard(endlessJob());
  heard.worker().start();
  ASSERT_TRUE(heard.waitForProgress());
  heard.worker().cancel();
  ASSERT_TRUE(heard.wait("cancelled"));
  EXPECT_EQ(heard.events(), (QStringList{"started", "cancelled"}));  // the step was never done
  EXPECT_EQ(heard.worker().result(), nullptr);
}

TEST(RunWorker, CanBeDestroyedInsideAStepAndIsSilentThen) {
  Heard heard(endlessJob());
  heard.worker().start();
  ASSERT_TRUE(heard.waitForProgress());
  heard.destroyWorker();
  const QStringList before = heard.events();
  QTest::qWait(20);
  EXPECT_EQ(heard.events(), before);
}

TEST(RunWorker, NobodyWaitsForASourceThatDoesNotHear) {
  RunJob job = jobOf(2, 10);
  std::promise<void> opened;
  std::promise<void> go_on;
  job.feed = std::make_shared<RunFeed>(
      [&](const std::stop_token&, const std::function<void(double)>&) {
        opened.set_value();
        go_on.get_future().wait();
        return std::unique_ptr<ObservationSource>();
      },
      job.settings.perception);
  Heard heard(std::move(job));
  heard.worker().start();
  opened.get_future().wait();
  heard.destroyWorker();
  EXPECT_FALSE(waitForBackground(std::chrono::milliseconds(1)));
  go_on.set_value();
  EXPECT_TRUE(waitForBackground(std::chrono::seconds(30)));
  QTest::qWait(10);
  EXPECT_TRUE(heard.events().isEmpty());
}

TEST(RunWorker, WarnsAtTheEndOfARunThatRecognisedNothing) {
  RunJob job = jobOf(2, 10);
  job.drawing.start = Pose2{5000.0, 0.0, 0.0};
  Heard heard(std::move(job));
  heard.worker().start();
  ASSERT_TRUE(heard.wait("finished"));
  ASSERT_EQ(heard.worker().result()->warnings.size(), 1U);
  EXPECT_EQ(heard.worker().result()->warnings[0].code, "nothing_recognised");
}

TEST(RunWorker, CanBeDestroyedWhilePausedAndBeforeTheStart) {
  Heard paused(endlessJob());
  paused.worker().pause();
  paused.worker().start();
  ASSERT_TRUE(paused.wait("paused"));
  paused.destroyWorker();
  Heard never_started(endlessJob());
  never_started.destroyWorker();
  EXPECT_TRUE(never_started.events().isEmpty());
}

TEST(RunWorker, TellsOfABadJobWithItsCode) {
  RunJob job = jobOf(2, 10);
  job.drawing.start.reset();
  Heard heard(std::move(job));
  heard.worker().start();
  ASSERT_TRUE(heard.wait("failed"));
  EXPECT_EQ(heard.failure().code, ErrorCode::BadInput);
  EXPECT_FALSE(heard.failure().message.isEmpty());
}

TEST(RunWorker, TellsOfASourceThatCannotBeOpened) {
  RunJob job = jobOf(2, 10);
  job.feed = std::make_shared<RunFeed>(
      [](const std::stop_token&,
         const std::function<void(double)>&) -> std::unique_ptr<ObservationSource> {
        throw Error(ErrorCode::BadInput, "frames.csv: gone", "Put it back.");
      },
      job.settings.perception);
  Heard heard(std::move(job));
  heard.worker().start();
  ASSERT_TRUE(heard.wait("failed"));
  EXPECT_EQ(heard.events(), QStringList{"failed"});
  EXPECT_EQ(heard.failure().message, "frames.csv: gone");
  EXPECT_EQ(heard.failure().hint, "Put it back.");
}

TEST(RunWorker, GoesOnAfterAFrameThatCannotBeRead) {
  Heard heard(jobOf(3, 10, true));
  heard.worker().start();
  ASSERT_TRUE(heard.wait("finished"));
  EXPECT_EQ(heard.events().count("skipped"), 1);
  EXPECT_EQ(heard.reports(), 2);
}

TEST(RunWorker, RunsUntilAndPauses) {
  RunJob job = jobOf(5, 10);
  job.until = 2;
  Heard heard(std::move(job));
  heard.worker().start();
  ASSERT_TRUE(heard.wait("paused"));
  EXPECT_EQ(heard.worker().result()->last->index, 2);
  heard.worker().runUntil(4);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return heard.worker().result()->last->index == 4 && heard.events().back() == "paused";
      },
      kWorkerPatienceMs));
  heard.worker().resume();
  ASSERT_TRUE(heard.wait("finished"));
  const auto& history = heard.worker().history();
  EXPECT_EQ(history->first(), 1);
  EXPECT_EQ(history->newest(), 5);
  EXPECT_EQ(formatMap(*history->at(5)->map), formatMap(heard.worker().result()->map()));
}

TEST(RunWorker, AnotherRunGoesOverWhatWasPerceivedAndThenOn) {
  const RunJob whole = jobOf(5, 10);
  Heard alone(whole);
  alone.worker().start();
  ASSERT_TRUE(alone.wait("finished"));

  RunJob first = jobOf(5, 10);
  const auto feed = first.feed;
  first.until = 3;
  auto before = std::make_unique<Heard>(std::move(first));
  before->worker().start();
  ASSERT_TRUE(before->wait("paused"));
  RunJob second;
  second.drawing = whole.drawing;
  second.settings = whole.settings;
  second.feed = feed;
  second.until = 3;
  Heard after(std::move(second));
  after.worker().start();
  ASSERT_TRUE(after.wait("paused"));
  EXPECT_EQ(feed->tape()->end(), 3U);
  before.reset();  // in the middle of a recording: the other goes on with it
  after.worker().resume();
  ASSERT_TRUE(after.wait("finished"));
  EXPECT_EQ(formatMap(after.worker().result()->map()), formatMap(alone.worker().result()->map()));
}

}  // namespace
}  // namespace handmap
