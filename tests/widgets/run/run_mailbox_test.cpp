#include "widgets/run/run_mailbox.h"

#include <QCoreApplication>
#include <QTest>
#include <thread>

#include <gtest/gtest.h>

namespace handmap {
namespace {

std::shared_ptr<const Snapshot> snapshotOf(int index) {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->index = index;
  snapshot->report.frame = index;
  return snapshot;
}

class RunMailboxTest : public testing::Test {
 protected:
  RunMailboxTest() {
    QObject::connect(&mailbox_, &RunMailbox::arrived, &mailbox_, [this](const RunNews& news) {
      indices_.push_back(news.newest->index);
      for (const FrameReport& report : news.reports) frames_.push_back(report.frame);
    });
  }

  RunMailbox mailbox_;
  std::vector<int> indices_;
  std::vector<int> frames_;
};

TEST_F(RunMailboxTest, DeliversTheNewestOnceHoweverManyWerePosted) {
  for (int i = 0; i <= 1000; ++i) mailbox_.post(snapshotOf(i));
  EXPECT_TRUE(indices_.empty()) << "delivered inside post()";
  ASSERT_TRUE(QTest::qWaitFor([this] { return !indices_.empty(); }));
  QTest::qWait(50);
  EXPECT_EQ(indices_, std::vector{1000});
}

TEST_F(RunMailboxTest, LosesNoReport) {
  for (int i = 0; i < 100; ++i) mailbox_.post(snapshotOf(i));
  ASSERT_TRUE(QTest::qWaitFor([this] { return !indices_.empty(); }));
  ASSERT_EQ(frames_.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(frames_[static_cast<std::size_t>(i)], i);
}

TEST_F(RunMailboxTest, IsReadyAgainAfterADelivery) {
  mailbox_.post(snapshotOf(1));
  ASSERT_TRUE(QTest::qWaitFor([this] { return indices_.size() == 1; }));
  mailbox_.post(snapshotOf(2));
  ASSERT_TRUE(QTest::qWaitFor([this] { return indices_.size() == 2; }));
  EXPECT_EQ(indices_, (std::vector{1, 2}));
}

TEST_F(RunMailboxTest, FlushDeliversAtOnceAndOnlyOnce) {
  mailbox_.post(snapshotOf(1));
  mailbox_.flush();
  EXPECT_EQ(indices_, std::vector{1});
  QTest::qWait(50);
  EXPECT_EQ(indices_, std::vector{1});
}

TEST_F(RunMailboxTest, TheLastOfAnotherThreadAlwaysArrives) {
  constexpr int kPosts = 20000;
  std::jthread poster([this] {
    for (int i = 1; i <= kPosts; ++i) mailbox_.post(snapshotOf(i));
  });
  ASSERT_TRUE(
      QTest::qWaitFor([this] { return !indices_.empty() && indices_.back() == kPosts; }, 30000));
  EXPECT_TRUE(std::ranges::is_sorted(indices_));
  EXPECT_EQ(frames_.size(), static_cast<std::size_t>(kPosts));
}

}  // namespace
}  // namespace handmap
