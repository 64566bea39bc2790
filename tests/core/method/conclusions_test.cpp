#include "core/method/conclusions.h"

#include <atomic>
#include <memory>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace handmap {
namespace {

Conclusion named(const std::string& name) {
  Conclusion conclusion;
  conclusion.map.name = name;
  return conclusion;
}

std::optional<Conclusion> waitFor(Conclusions& conclusions) {
  for (;;) {
    if (auto conclusion = conclusions.take()) return conclusion;
    std::this_thread::yield();
  }
}

TEST(Conclusions, AreBegunAfterEachStretchOfTheWay) {
  // One that takes no time needs no rest: the way alone decides, however busy the machine is.
  Conclusions conclusions([] { return Conclusions::Clock::time_point{}; });
  std::vector<std::string> taken;
  for (double way_m = 0.0; way_m < 300.0; way_m += 1.0) {
    bool begun = false;
    conclusions.begin(way_m, [&] {
      begun = true;
      return [name = std::to_string(static_cast<int>(way_m))](const std::stop_token&) {
        return std::optional(named(name));
      };
    });
    if (begun) taken.push_back(waitFor(conclusions)->map.name);
  }
  EXPECT_EQ(taken, (std::vector<std::string>{"20", "40", "60", "80", "100", "120", "140", "160",
                                             "180", "200", "220", "242", "267", "294"}));
}

TEST(Conclusions, RestLongerThanTheyTake) {
  std::atomic<int> now_s = 0;
  Conclusions conclusions(
      [&] { return Conclusions::Clock::time_point(std::chrono::seconds(now_s)); });
  const auto takesFiveSeconds = [&] {
    return [&](const std::stop_token&) {
      now_s += 5;
      return std::optional(named("slow"));
    };
  };
  conclusions.begin(20.0, takesFiveSeconds);
  waitFor(conclusions);
  bool begun = false;
  for (double way_m = 40.0; !begun; way_m += 20.0, ++now_s) {
    conclusions.begin(way_m, [&]() -> Conclusions::Make {
      EXPECT_EQ(now_s, 5 + 2 * 5);
      begun = true;
      return takesFiveSeconds();
    });
  }
}

TEST(Conclusions, LetGoOfWhatTheyAreMadeFrom) {
  auto known = std::make_shared<int>(1);
  const std::weak_ptr<int> watched = known;
  Conclusions conclusions;
  conclusions.begin(20.0, [&] {
    return [known = std::exchange(known, nullptr)](const std::stop_token&) {
      return std::optional(named(std::to_string(*known)));
    };
  });
  EXPECT_EQ(waitFor(conclusions)->map.name, "1");
  EXPECT_TRUE(watched.expired());
}

TEST(Conclusions, KeepNobodyWaiting) {
  Conclusions conclusions;
  std::atomic<bool> ended = false;
  const auto endless = [&] {
    return [&](const std::stop_token& stop) -> std::optional<Conclusion> {
      while (!stop.stop_requested()) std::this_thread::yield();
      ended = true;
      return std::nullopt;
    };
  };
  conclusions.begin(20.0, endless);
  EXPECT_FALSE(conclusions.take());
  conclusions.begin(100.0, [&]() -> Conclusions::Make {
    ADD_FAILURE() << "one at a time";
    return endless();
  });
  conclusions = {};
  EXPECT_TRUE(ended);
  EXPECT_FALSE(conclusions.take());
}

TEST(Conclusions, OneThatCannotBeMadeIsToldAndEndsNothing) {
  Conclusions conclusions;
  conclusions.begin(20.0, [] {
    return [](const std::stop_token&) -> std::optional<Conclusion> {
      throw Error(ErrorCode::RunFailed, "too little to go by");
    };
  });
  while (conclusions.trouble().empty()) {
    EXPECT_FALSE(conclusions.take());
    std::this_thread::yield();
  }
  EXPECT_EQ(conclusions.trouble(), "too little to go by");
  bool begun = false;
  for (double way_m = 40.0; !begun; way_m += 1.0) {
    conclusions.begin(way_m, [&] {
      begun = true;
      return [](const std::stop_token&) { return std::optional(named("the next one")); };
    });
  }
  EXPECT_EQ(waitFor(conclusions)->map.name, "the next one");
  conclusions.end();
  EXPECT_EQ(conclusions.trouble(), "too little to go by");
}

}  // namespace
}  // namespace handmap
