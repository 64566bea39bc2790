#include "app/gui/run/run_controller.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include "core/simulation/simulated_source.h"
#include "widgets/background/background.h"

namespace handmap {
namespace {

constexpr int kRunPatienceMs = 60'000;

class RunControllerTest : public testing::Test {
 protected:
  RunControllerTest() { run_.setSpeed(0.0); }
  ~RunControllerTest() override {
    run_.discard();
    EXPECT_TRUE(waitForBackground(std::chrono::seconds(30)));
  }
  void start(RunController::Begin begin = RunController::Begin::Running) {
    RunSetup setup;
    setup.settings.threads = 1;
    run_.start(drawing_, simulatedRobot("rows", world_, 2), setup, begin);
  }
  bool waitFor(RunState state) {
    return QTest::qWaitFor([&] { return run_.state() == state; }, kRunPatienceMs);
  }

  World world_ = twoRowWorld(2);
  Map drawing_ = perturbed(world_.map, 2.0, 2);
  RunController run_;
};

TEST_F(RunControllerTest, KeepsTheResultOfARunThatHasEnded) {
  QSignalSpy finished(&run_, &RunController::finished);
  start();
  EXPECT_TRUE(run_.isActive());
  EXPECT_EQ(run_.result(), nullptr);
  ASSERT_TRUE(waitFor(RunState::Idle));
  ASSERT_EQ(finished.count(), 1);
  EXPECT_FALSE(finished[0][0].toBool()) << "not cancelled";
  ASSERT_NE(run_.result(), nullptr);
  EXPECT_FALSE(run_.result()->map().refinement.empty());
  EXPECT_EQ(run_.drawing(), drawing_);
}

TEST_F(RunControllerTest, StopsAStepThatIsAtRest) {
  QSignalSpy finished(&run_, &RunController::finished);
  start(RunController::Begin::WithOneStep);
  ASSERT_TRUE(waitFor(RunState::Paused));
  const auto result = run_.result();
  run_.stop();
  EXPECT_EQ(run_.state(), RunState::Stopping);
  run_.pause();
  ASSERT_TRUE(waitFor(RunState::Idle));
  EXPECT_TRUE(finished.value(0).value(0).toBool()) << "cancelled";
  EXPECT_EQ(run_.result(), result);
}

TEST_F(RunControllerTest, EachRunHasANumberAndADiscardedOneHasNone) {
  start();
  const int first = run_.number();
  run_.discard();
  EXPECT_NE(run_.number(), first);
  EXPECT_EQ(run_.state(), RunState::Idle);
  EXPECT_EQ(run_.drawing(), Map());
  const int none = run_.number();
  start();
  EXPECT_NE(run_.number(), none);
}

TEST_F(RunControllerTest, DiscardingReturnsAtOnceAndIsFinal) {
  for (int i = 0; i < 5; ++i) {
    QSignalSpy heard(&run_, &RunController::finished);
    QSignalSpy opened(&run_, &RunController::sourceOpened);
    start();
    run_.discard();
    ASSERT_TRUE(waitForBackground(std::chrono::seconds(30)));
    QTest::qWait(5);
    EXPECT_EQ(heard.count() + opened.count(), 0);
  }
}

}  // namespace
}  // namespace handmap
