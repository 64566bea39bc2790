#include "core/base/parallel.h"

#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/plain_threads.h"

namespace handmap {
namespace {

TEST(Parallel, DoesEveryPartOnce) {
  std::vector<int> done(1000, 0);
  Arena(3).execute([&] { parallelFor(done.size(), [&](std::size_t i) { ++done[i]; }); });
  EXPECT_EQ(done, std::vector<int>(1000, 1));
  EXPECT_NO_THROW(parallelFor(0, [](std::size_t) { FAIL(); }));
  EXPECT_EQ(Arena(1).execute([] { return 7; }), 7);
}

TEST(Parallel, CutsIntoStretches) {
  std::vector<int> done(100, 0);
  parallelStretches(100, 32, [&](int begin, int end) {
    EXPECT_LE(end - begin, 32);
    for (int i = begin; i < end; ++i) ++done[static_cast<std::size_t>(i)];
  });
  EXPECT_EQ(done, std::vector<int>(100, 1));
  EXPECT_NO_THROW(parallelStretches(0, 8, [](int, int) { FAIL(); }));
}

TEST(Parallel, PassesOnWhatIsThrown) {
  const auto throwing = [](std::size_t i) {
    if (i == 17) throw std::runtime_error("seventeen");
  };
  EXPECT_THROW(parallelFor(100, throwing), std::runtime_error);
  EXPECT_THROW(plain::parallelFor(100, throwing), std::runtime_error);
}

TEST(Parallel, KeepsAValueForEachThread) {
  PerThread<long> sums;
  parallelFor(1000, [&](std::size_t i) { sums.local() += static_cast<long>(i); });
  EXPECT_EQ(std::accumulate(sums.begin(), sums.end(), 0L), 499'500L);
}

TEST(PlainThreads, DivideTheWorkButNotItsParts) {
  plain::PerThread<long> sums;
  std::vector<int> done(64, 0);
  plain::Arena(4).execute([&] {
    plain::parallelFor(8, [&](std::size_t i) {
      const int member = plain::team.member;
      plain::parallelFor(8, [&](std::size_t j) {
        EXPECT_EQ(plain::team.member, member);
        ++done[8 * i + j];
        ++sums.local();
      });
    });
  });
  EXPECT_EQ(done, std::vector<int>(64, 1));
  EXPECT_EQ(std::accumulate(sums.begin(), sums.end(), 0L), 64L);
  EXPECT_FALSE(plain::team.divided);
}

}  // namespace
}  // namespace handmap
