#include "widgets/run/worker/run_mailbox.h"

#include <QCoreApplication>
#include <QTest>
#include <condition_variable>
#include <mutex>
#include <new>
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

/// A preparation that waits until it may end.
struct Gate {
  std::mutex mutex;
  std::condition_variable opened;
  int open_for = 0;  ///< snapshots
  std::vector<int> prepared;

  RunMailbox::Prepare prepare() {
    return [this](const Snapshot& snapshot) {
      std::unique_lock lock(mutex);
      prepared.push_back(snapshot.index);
      opened.wait(lock, [&] { return open_for > 0; });
      --open_for;
    };
  }
  std::size_t entered() {
    const std::scoped_lock lock(mutex);
    return prepared.size();
  }
  void open(int snapshots) {
    const std::scoped_lock lock(mutex);
    open_for = snapshots;
    opened.notify_all();
  }
};

/// Posts a first snapshot and waits until it is being prepared.
void postTo(RunMailbox& mailbox, Gate& gate) {
  mailbox.setPrepare(gate.prepare());
  mailbox.post(snapshotOf(1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return gate.entered() == 1; }));
}

TEST_F(RunMailboxTest, WhatIsPreparedIsWhatArrives) {
  Gate gate;
  ASSERT_NO_FATAL_FAILURE(postTo(mailbox_, gate));
  mailbox_.post(snapshotOf(2));
  mailbox_.post(snapshotOf(3));
  QTest::qWait(50);
  EXPECT_TRUE(indices_.empty()) << "delivered before it was prepared";
  gate.open(2);
  ASSERT_TRUE(QTest::qWaitFor([this] { return indices_.size() == 2; }));
  EXPECT_EQ(indices_, (std::vector{1, 3}));
  EXPECT_EQ(frames_, (std::vector{1, 2, 3}));
  EXPECT_EQ(gate.prepared, indices_);
}

TEST_F(RunMailboxTest, FlushDoesNotWaitForThePreparation) {
  Gate gate;
  ASSERT_NO_FATAL_FAILURE(postTo(mailbox_, gate));
  mailbox_.post(snapshotOf(2));
  mailbox_.flush();
  EXPECT_EQ(indices_, std::vector{2});
  EXPECT_EQ(frames_, (std::vector{1, 2}));
  mailbox_.post(snapshotOf(3));
  gate.open(2);
  ASSERT_TRUE(QTest::qWaitFor([this] { return indices_.size() == 2; }));
  QTest::qWait(50);
  EXPECT_EQ(indices_, (std::vector{2, 3})) << "the first one came late";
  EXPECT_TRUE(waitForBackground(std::chrono::seconds(5)));
}

TEST_F(RunMailboxTest, APreparationThatFailsHoldsNothingBack) {
  mailbox_.setPrepare([](const Snapshot&) { throw std::bad_alloc(); });
  mailbox_.post(snapshotOf(1));
  ASSERT_TRUE(QTest::qWaitFor([this] { return !indices_.empty(); }));
  EXPECT_EQ(indices_, std::vector{1});
}

TEST(RunMailboxEndTest, MayGoWhileItPrepares) {
  Gate gate;
  auto mailbox = std::make_unique<RunMailbox>();
  ASSERT_NO_FATAL_FAILURE(postTo(*mailbox, gate));
  mailbox.reset();
  gate.open(1);
  EXPECT_TRUE(waitForBackground(std::chrono::seconds(5)));
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
