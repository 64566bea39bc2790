#include "core/method/conclusions.h"

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

std::optional<Conclusion> waitFor(Conclusions& conclusions) {
  for (;;) {
    if (auto conclusion = conclusions.take()) return conclusion;
    std::this_thread::yield();
  }
}

TEST(Conclusions, AreBegunAfterEachStretchOfTheWay) {
  Conclusions conclusions;
  std::vector<std::string> taken;
  for (double way_m = 0.0; way_m < 300.0; way_m += 1.0) {
    bool begun = false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // they take next to nothing
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
  constexpr auto kTakes = std::chrono::milliseconds(50);
  Conclusions conclusions;
  const auto slow = [&] {
    return [&](const std::stop_token&) {
      std::this_thread::sleep_for(kTakes);
      return std::optional(named("slow"));
    };
  };
  conclusions.begin(20.0, slow);
  waitFor(conclusions);
  const auto since = std::chrono::steady_clock::now();
  bool begun = false;
  for (double way_m = 40.0; !begun; way_m += 20.0) {
    conclusions.begin(way_m, [&]() -> Conclusions::Make {
      begun = true;
      return slow();
    });
    std::this_thread::yield();
  }
  EXPECT_GE(std::chrono::steady_clock::now() - since, 2 * kTakes);
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
