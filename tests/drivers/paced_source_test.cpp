#include "drivers/pace/paced_source.h"

#include <thread>

#include <gtest/gtest.h>

#include "tests/drivers/list_source.h"

namespace handmap {
namespace {

using namespace std::chrono_literals;

PacedSource paced(std::vector<double> times, std::shared_ptr<Pace> pace,
                  std::stop_token stop = {}) {
  return {std::make_unique<ListSource>(std::move(times)), std::move(pace), std::move(stop)};
}

TEST(PacedSource, ReleasesNoFasterThanTheClockTimesTheSpeed) {
  PacedSource source = paced({10.0, 10.5, 11.0}, std::make_shared<Pace>(10.0));
  const auto begin = Pace::Clock::now();
  while (source.next()) {
  }
  EXPECT_GE(Pace::Clock::now() - begin, 100ms);
}

TEST(PacedSource, SpeedZeroPassesEverythingOnUnchanged) {
  PacedSource source = paced({0.0, 1e6, 2e6}, std::make_shared<Pace>(0.0));
  EXPECT_EQ(source.info().observations, 3);
  for (int frame = 0; frame < 3; ++frame) EXPECT_EQ(source.next()->frame, frame);
  EXPECT_FALSE(source.next());
}

TEST(PacedSource, TheFirstObservationIsNotWaitedFor) {
  PacedSource source = paced({1e6}, std::make_shared<Pace>(1.0));
  EXPECT_TRUE(source.next());
}

// Each of these would wait for a minute if nobody woke it; the test then runs into its time limit.
TEST(PacedSource, AStopWakesIt) {
  std::stop_source stop;
  PacedSource source = paced({0.0, 1e6}, std::make_shared<Pace>(1.0), stop.get_token());
  source.next();
  const auto begin = Pace::Clock::now();
  const std::jthread stopper([&stop] {
    std::this_thread::sleep_for(20ms);
    stop.request_stop();
  });
  EXPECT_TRUE(source.next());
  EXPECT_LT(Pace::Clock::now() - begin, 10s);
}

TEST(PacedSource, AChangeOfSpeedIsTakenUpWhileWaiting) {
  const auto pace = std::make_shared<Pace>(1.0);
  PacedSource source = paced({0.0, 1e6}, pace);
  source.next();
  const auto begin = Pace::Clock::now();
  const std::jthread changer([&pace] {
    std::this_thread::sleep_for(20ms);
    pace->setSpeed(0.0);
  });
  EXPECT_TRUE(source.next());
  EXPECT_LT(Pace::Clock::now() - begin, 10s);
}

TEST(PacedSource, TimeGoingBackwardsIsNotWaitedFor) {
  PacedSource source = paced({100.0, 0.0}, std::make_shared<Pace>(0.001));
  EXPECT_EQ(source.next()->time_s, 100.0);
  EXPECT_EQ(source.next()->time_s, 0.0);
}

}  // namespace
}  // namespace handmap
