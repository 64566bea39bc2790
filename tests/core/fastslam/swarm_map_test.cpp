#include "core/fastslam/swarm_map.h"

#include <map>

#include <gtest/gtest.h>

namespace handmap {
namespace {

std::shared_ptr<Swarm> numbered(int number) {
  auto swarm = std::make_shared<Swarm>(1);
  swarm->observations = number;
  return swarm;
}

TEST(SwarmMap, HoldsWhatWasSetWhateverTheNumberOfBuildings) {
  for (const std::size_t buildings : {1U, 8U, 9U, 64U, 65U, 10000U}) {
    SwarmMap map(buildings);
    EXPECT_EQ(map.find(buildings - 1), nullptr);
    for (std::size_t b = 0; b < buildings; b += 1 + buildings / 100) {
      map.set(b, numbered(static_cast<int>(b)));
    }
    for (std::size_t b = 0; b < buildings; ++b) {
      const Swarm* swarm = map.find(b);
      ASSERT_EQ(swarm != nullptr, b % (1 + buildings / 100) == 0) << b;
      if (swarm == nullptr) continue;
      EXPECT_EQ(swarm->observations, static_cast<int>(b));
    }
  }
}

TEST(SwarmMap, CopiesDoNotChangeEachOther) {
  // Three generations that change at random, each beside a plain map that does the same.
  RandomStream random(1);
  std::vector<SwarmMap> maps(4, SwarmMap(500));
  std::vector<std::map<std::size_t, int>> plain(4);
  for (int i = 0; i < 3000; ++i) {
    const auto one = static_cast<std::size_t>(random.index(4));
    if (random.uniform() < 0.1) {
      const auto other = static_cast<std::size_t>(random.index(4));
      maps[one] = maps[other];
      plain[one] = plain[other];
    }
    const auto building = static_cast<std::size_t>(random.index(500));
    maps[one].set(building, numbered(i));
    plain[one][building] = i;
  }
  for (std::size_t m = 0; m < maps.size(); ++m) {
    for (std::size_t b = 0; b < 500; ++b) {
      const Swarm* swarm = maps[m].find(b);
      ASSERT_EQ(swarm != nullptr, plain[m].count(b) == 1);
      if (swarm == nullptr) continue;
      EXPECT_EQ(swarm->observations, plain[m][b]);
    }
  }
}

TEST(SwarmMap, ReleasesWhatNobodyHolds) {
  const auto swarm = numbered(1);
  {
    SwarmMap map(100);
    map.set(42, swarm);
    const SwarmMap copy = map;
    map.set(42, numbered(2));
    EXPECT_EQ(swarm.use_count(), 2);
    EXPECT_EQ(copy.find(42), swarm.get());
  }
  EXPECT_EQ(swarm.use_count(), 1);
}

}  // namespace
}  // namespace handmap
