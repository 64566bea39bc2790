#include "core/sketching/box_index.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

TEST(BoxIndex, FindsWhatALookAtEachFinds) {
  RandomStream random(11, 0, 0);
  for (const std::size_t count : {0u, 1u, 7u, 500u}) {
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 low(random.uniform(-100.0, 100.0), random.uniform(-900.0, 900.0));
      const double size = i % 50 == 0 ? 400.0 : 5.0;
      boxes.push_back({low, low + size * Vec2(random.uniform(), random.uniform())});
    }
    const BoxIndex index(boxes);
    for (int look = 0; look < 200; ++look) {
      const Vec2 low(random.uniform(-150.0, 150.0), random.uniform(-1000.0, 1000.0));
      const Bounds area{low, low + 60.0 * Vec2(random.uniform(), random.uniform())};
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < count; ++i)
        if ((boxes[i].low.array() <= area.high.array()).all() &&
            (area.low.array() <= boxes[i].high.array()).all())
          expected.push_back(i);
      EXPECT_EQ(index.touching(area), expected);
    }
  }
}

TEST(BoxIndex, BordersTouch) {
  const BoxIndex index({{{0, 0}, {1, 1}}, {{5, 5}, {5, 5}}});
  EXPECT_EQ(index.touching({{1, 1}, {2, 2}}), std::vector<std::size_t>{0});
  EXPECT_EQ(index.touching({{5, 5}, {5, 5}}), std::vector<std::size_t>{1});
}

}  // namespace
}  // namespace handmap
