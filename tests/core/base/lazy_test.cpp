#include "core/base/lazy.h"

#include <array>
#include <thread>

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(Lazy, IsMadeOnceForAllCopies) {
  int made = 0;
  const Lazy<int> lazy([&made] { return ++made; });
  const Lazy<int> copy = lazy;
  EXPECT_EQ(made, 0);
  EXPECT_EQ(*copy, 1);
  EXPECT_EQ(*lazy, 1);
  EXPECT_EQ(copy, lazy);
  EXPECT_FALSE(Lazy<int>());
  EXPECT_TRUE(lazy);
}

TEST(Lazy, ACopyOfItsOwnKeepsWhatIsMadeToItself) {
  int made = 0;
  const Lazy<int> lazy([&made] { return ++made; });
  const Lazy<int> own = lazy.again();
  EXPECT_NE(own, lazy);
  EXPECT_EQ(*own, 1);
  EXPECT_EQ(*lazy, 2);
  EXPECT_EQ(lazy.again(), lazy) << "there is nothing left to make it of";
  EXPECT_FALSE(Lazy<int>().again());
}

TEST(Lazy, LetsWhatItWasMadeOfGo) {
  const auto source = std::make_shared<int>(3);
  const Lazy<int> lazy([source] { return *source; });
  EXPECT_EQ(source.use_count(), 2);
  EXPECT_EQ(*lazy, 3);
  EXPECT_EQ(source.use_count(), 1);
}

/// What it does wrong only the thread sanitizer sees.
TEST(Lazy, IsReadAndCopiedByManyAtATime) {
  for (int round = 0; round < 200; ++round) {
    const Lazy<int> lazy([] { return 5; });
    std::array<std::thread, 4> threads;
    for (std::size_t i = 0; i < threads.size(); ++i) {
      threads[i] = std::thread([&lazy, i] {
        const Lazy<int> own = i % 2 == 0 ? lazy : lazy.again();
        EXPECT_EQ(own.again().get(), 5);
        EXPECT_EQ(own.get(), 5);
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
}

}  // namespace
}  // namespace handmap
