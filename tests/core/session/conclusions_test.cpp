#include "core/session/conclusions.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace handmap {
namespace {

Conclusion named(const std::string& name) {
  Conclusion conclusion;
  conclusion.map.name = name;
  return conclusion;
}

TEST(Conclusions, AreTakenATenthOfTheWayLater) {
  Conclusions conclusions;
  std::vector<std::string> taken;
  for (double way_m = 0.0; way_m < 100.0; way_m += 1.0) {
    if (const auto conclusion = conclusions.take(way_m, {})) taken.push_back(conclusion->map.name);
    conclusions.begin(way_m, [way_m] {
      return [name = std::to_string(static_cast<int>(way_m))](const std::stop_token&) {
        return std::optional(named(name));
      };
    });
  }
  EXPECT_EQ(taken, (std::vector<std::string>{"20", "30", "45", "68"}));
}

TEST(Conclusions, DoNotKeepAStopWaiting) {
  Conclusions conclusions;
  std::atomic<bool> ended = false;
  conclusions.begin(20.0, [&] {
    return [&](const std::stop_token& stop) -> std::optional<Conclusion> {
      while (!stop.stop_requested()) std::this_thread::yield();
      ended = true;
      return std::nullopt;
    };
  });
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(conclusions.isDue(30.0));
  EXPECT_FALSE(conclusions.take(30.0, stop.get_token()));
  EXPECT_TRUE(conclusions.isDue(30.0));
  conclusions = {};
  EXPECT_TRUE(ended);
  EXPECT_FALSE(conclusions.isDue(1e6));
}

TEST(Conclusions, PassOnWhatWentWrong) {
  Conclusions conclusions;
  conclusions.begin(20.0, [] {
    return [](const std::stop_token&) -> std::optional<Conclusion> {
      throw Error(ErrorCode::RunFailed, "no more memory");
    };
  });
  EXPECT_THROW(conclusions.take(30.0, {}), Error);
}

}  // namespace
}  // namespace handmap
