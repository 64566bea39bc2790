#include "drivers/pace/punctual_source.h"

#include <thread>

#include <gtest/gtest.h>

#include "tests/drivers/list_source.h"

namespace handmap {
namespace {

using namespace std::chrono_literals;

PunctualSource punctual(std::vector<double> times, double speed, std::stop_token stop = {}) {
  return {std::make_unique<ListSource>(std::move(times)), speed, std::move(stop)};
}

TEST(PunctualSource, KeepsToTheClockTimesTheSpeed) {
  PunctualSource source = punctual({10.0, 10.5, 11.0}, 10.0);
  EXPECT_EQ(source.info().speed, 10.0);
  const auto begin = Pace::Clock::now();
  EXPECT_TRUE(source.next());
  try {
    while (source.next()) {
    }
  } catch (const FrameError&) {  // a busy machine
  }
  EXPECT_GE(Pace::Clock::now() - begin, 50ms);
}

TEST(PunctualSource, PassesOverWhatComesTooLateAndSaysSo) {
  PunctualSource source = punctual({0.0, 0.1, 0.2, 0.3, 1000.0}, 1.0);
  EXPECT_EQ(source.next()->frame, 0);
  std::this_thread::sleep_for(450ms);
  for (int frame = 1; frame <= 2; ++frame) {
    try {
      source.next();
      ADD_FAILURE() << frame;
    } catch (const FrameError& error) {
      EXPECT_EQ(error.frame(), frame);
      EXPECT_NE(std::string(error.what()).find("the budget is 0.10 s"), std::string::npos);
    }
  }
}

TEST(PunctualSource, AStopWakesIt) {
  std::stop_source stop;
  PunctualSource source = punctual({0.0, 60.0}, 1.0, stop.get_token());
  EXPECT_TRUE(source.next());
  std::jthread waker([&stop] {
    std::this_thread::sleep_for(50ms);
    stop.request_stop();
  });
  EXPECT_TRUE(source.next());
}

}  // namespace
}  // namespace handmap
