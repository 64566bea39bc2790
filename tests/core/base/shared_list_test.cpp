#include "core/base/shared_list.h"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(SharedList, AVersionNeverChanges) {
  std::vector<int> numbers(200);
  std::iota(numbers.begin(), numbers.end(), 0);
  SharedListWriter<int> writer(numbers);
  const SharedList<int> before = writer.share();
  writer.set(70, -1);
  writer.push_back(200);
  const SharedList<int> after = writer.share();
  EXPECT_EQ(before.all(), numbers);
  numbers[70] = -1;
  numbers.push_back(200);
  EXPECT_EQ(after.all(), numbers);
  EXPECT_EQ(after.size(), 201U);
  EXPECT_EQ(after.back(), 200);
  EXPECT_EQ(writer[70], -1);
}

TEST(SharedList, VersionsShareWhatHasNotChanged) {
  SharedListWriter<int> writer(std::vector<int>(200, 7));
  const SharedList<int> before = writer.share();
  writer.set(70, 8);
  const SharedList<int> after = writer.share();
  EXPECT_EQ(&before[0], &after[0]);
  EXPECT_NE(&before[70], &after[70]);
  EXPECT_EQ(&before[199], &after[199]);
  EXPECT_TRUE(SharedList<int>().empty());
}

TEST(SharedList, OfManyPagesIsTheSameList) {
  std::vector<int> numbers;
  SharedListWriter<int> writer;
  std::vector<SharedList<int>> versions;
  std::vector<std::vector<int>> expected;
  for (int i = 0; i < 10'000; ++i) {
    numbers.push_back(i);
    writer.push_back(i);
    const std::size_t other = static_cast<std::size_t>(i) * 7919U % numbers.size();
    numbers[other] = -i;
    writer.set(other, -i);
    if (i % 997 != 0) continue;
    versions.push_back(writer.share());
    expected.push_back(numbers);
  }
  for (std::size_t v = 0; v < versions.size(); ++v) {
    EXPECT_EQ(versions[v].all(), expected[v]);
    EXPECT_EQ(versions[v].back(), expected[v].back());
  }
  EXPECT_EQ(writer.share()[4097], numbers[4097]);
}

}  // namespace
}  // namespace handmap
