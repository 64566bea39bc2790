#include "widgets/run/worker/run_feed.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "widgets/background/background.h"

namespace handmap {
namespace {

constexpr auto kPatience = std::chrono::seconds(30);

/// A device that takes its time to close, and has one reader.
struct Device {
  std::atomic<int> readers = 0;
  std::atomic<int> most_readers = 0;
};

class DeviceSource : public ObservationSource {
 public:
  DeviceSource(Device& device, std::stop_token stop) : device_(device), stop_(std::move(stop)) {
    most();
  }
  ~DeviceSource() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    --device_.readers;
  }
  const SourceInfo& info() const override { return info_; }
  /// Waits as a robot does that says nothing.
  std::optional<Observation> next() override {
    while (!stop_.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::nullopt;
  }

 private:
  void most() {
    const int readers = ++device_.readers;
    if (readers > device_.most_readers) device_.most_readers = readers;
  }

  Device& device_;
  std::stop_token stop_;
  SourceInfo info_;
};

RunFeed::Open opening(Device& device) {
  return [&device](const std::stop_token& stop, const std::function<void(double)>&) {
    return std::make_unique<DeviceSource>(device, stop);
  };
}

bool isReady(const RunFeed::Closed& closed) {
  return closed.wait_for(kPatience) == std::future_status::ready;
}

TEST(RunFeed, ClosesItsSourceInTheBackgroundWhenItEnds) {
  Device device;
  RunFeed feed(opening(device), {});
  const auto tape = feed.open({});
  EXPECT_EQ(device.readers, 1);
  std::thread run([&] { EXPECT_FALSE(tape->take(0, {})); });  // it waits for the robot
  const auto asked = std::chrono::steady_clock::now();
  feed.end();
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::milliseconds(50));
  EXPECT_TRUE(isReady(feed.closed()));
  EXPECT_EQ(device.readers, 0);
  run.join();
  EXPECT_EQ(feed.open({}), tape) << "what was perceived stays";
  feed.end();
}

TEST(RunFeed, ClosesItsSourceWhenNobodyHoldsIt) {
  Device device;
  RunFeed::Closed closed;
  {
    RunFeed feed(opening(device), {});
    closed = feed.closed();
    feed.open({});
  }
  EXPECT_TRUE(isReady(closed));
  EXPECT_EQ(device.readers, 0);
}

TEST(RunFeed, OpensWhatAnotherHasClosed) {
  Device device;
  auto first = std::make_unique<RunFeed>(opening(device), PerceptionOptions());
  first->open({});
  RunFeed second(opening(device), {}, first->closed());
  first.reset();
  EXPECT_TRUE(second.open({}));
  EXPECT_EQ(device.most_readers, 1);
}

TEST(RunFeed, IsNotOpenedOnceItHasEnded) {
  Device device;
  std::promise<void> never;
  RunFeed feed(opening(device), {}, never.get_future().share());
  std::thread run([&] { EXPECT_FALSE(feed.open({})); });  // it waits for the one before
  feed.end();
  run.join();
  EXPECT_TRUE(isReady(feed.closed()));
  EXPECT_EQ(device.most_readers, 0);
}

TEST(RunFeed, OneThatCannotBeOpenedIsClosed) {
  RunFeed feed(
      [](const std::stop_token&,
         const std::function<void(double)>&) -> std::unique_ptr<ObservationSource> {
        throw Error(ErrorCode::BadInput, "frames.csv: gone");
      },
      {});
  EXPECT_THROW(feed.open({}), Error);
  feed.end();
  EXPECT_TRUE(isReady(feed.closed()));
  EXPECT_TRUE(waitForBackground(kPatience));
}

}  // namespace
}  // namespace handmap
