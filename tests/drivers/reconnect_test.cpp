#include "drivers/device/reconnect.h"

#include <vector>

#include <gtest/gtest.h>

namespace handmap {
namespace {

using namespace std::chrono_literals;

std::vector<std::chrono::milliseconds> delays(std::uint64_t seed, int count) {
  Reconnect reconnect(seed);
  std::vector<std::chrono::milliseconds> result;
  for (int i = 0; i < count; ++i) result.push_back(reconnect.nextDelay());
  return result;
}

TEST(Reconnect, WaitsFromHalfASecondToEightSeconds) {
  std::chrono::milliseconds whole = 500ms;
  for (const auto delay : delays(1, 12)) {
    EXPECT_GE(delay, std::max(500ms, whole * 4 / 5));
    EXPECT_LE(delay, whole);
    whole = std::min(2 * whole, 8000ms);
  }
}

TEST(Reconnect, BeginsAnewAfterASuccess) {
  Reconnect reconnect(1);
  for (int i = 0; i < 6; ++i) reconnect.nextDelay();
  EXPECT_GT(reconnect.nextDelay(), 6s);
  reconnect.succeeded();
  EXPECT_EQ(reconnect.nextDelay(), 500ms);
}

TEST(Reconnect, SeedsTellDevicesApart) {
  EXPECT_EQ(delays(3, 8), delays(3, 8));
  EXPECT_NE(delays(3, 8), delays(4, 8));
}

}  // namespace
}  // namespace handmap
