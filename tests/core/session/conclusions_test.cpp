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

std::optional<Conclusion> waitFor(Conclusions& conclusions) {
  for (;;) {
    if (auto conclusion = conclusions.take()) return conclusion;
    std::this_thread::yield();
  }
}

TEST(Conclusions, AreBegunWhereTheWayIsHalfAsLongAgain) {
  Conclusions conclusions;
  std::vector<std::string> taken;
  for (double way_m = 0.0; way_m < 100.0; way_m += 1.0) {
    bool begun = false;
    conclusions.begin(way_m, [&] {
      begun = true;
      return [name = std::to_string(static_cast<int>(way_m))](const std::stop_token&) {
        return std::optional(named(name));
      };
    });
    if (begun) taken.push_back(waitFor(conclusions)->map.name);
  }
  EXPECT_EQ(taken, (std::vector<std::string>{"20", "30", "45", "68"}));
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

TEST(Conclusions, PassOnWhatWentWrong) {
  Conclusions conclusions;
  conclusions.begin(20.0, [] {
    return [](const std::stop_token&) -> std::optional<Conclusion> {
      throw Error(ErrorCode::RunFailed, "no more memory");
    };
  });
  EXPECT_THROW(waitFor(conclusions), Error);
}

}  // namespace
}  // namespace handmap
