#include "widgets/run/worker/playback.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include "widgets/run/panels/timeline.h"

namespace handmap {
namespace {

constexpr int kPatienceMs = 20'000;

std::shared_ptr<RunHistory> historyOf(int count) {
  auto history = std::make_shared<RunHistory>();
  for (int index = 1; index <= count; ++index) {
    Snapshot snapshot;
    snapshot.index = index;
    snapshot.report.time_s = 100.0 + 0.1 * index;
    history->add(snapshot);
  }
  return history;
}

class PlaybackTest : public testing::Test {
 protected:
  PlaybackTest() {
    QObject::connect(&playback_, &Playback::shown, &playback_,
                     [this](const auto& snapshot) { shown_.push_back(snapshot->index); });
    QObject::connect(&playback_, &Playback::caughtUp, &playback_, [this] { ++caught_up_; });
    playback_.setHistory(historyOf(20));
  }

  Playback playback_;
  std::vector<int> shown_;
  int caught_up_ = 0;
};

TEST_F(PlaybackTest, SeeksBackAndForth) {
  EXPECT_TRUE(playback_.atNewest());
  EXPECT_EQ(playback_.index(), 20);
  playback_.seek(7);
  EXPECT_FALSE(playback_.atNewest());
  EXPECT_EQ(playback_.index(), 7);
  playback_.stepBack();
  playback_.stepOn();
  playback_.stepOn();
  playback_.seek(-3);
  playback_.stepBack();
  EXPECT_EQ(shown_, (std::vector{7, 6, 7, 8, 1, 1}));
  playback_.seek(20);
  EXPECT_TRUE(playback_.atNewest());
  EXPECT_EQ(shown_.back(), 20);
  EXPECT_EQ(caught_up_, 0);  // nobody has played
}

TEST_F(PlaybackTest, PlaysEverySnapshotUpToTheNewest) {
  playback_.setSpeed(0.0);
  playback_.seek(15);
  playback_.play();
  ASSERT_TRUE(QTest::qWaitFor([this] { return caught_up_ == 1; }, kPatienceMs));
  EXPECT_EQ(shown_, (std::vector{15, 16, 17, 18, 19, 20}));
  EXPECT_FALSE(playback_.isPlaying());
  playback_.play();  // there is nothing to be played
  EXPECT_EQ(caught_up_, 2);
}

TEST_F(PlaybackTest, KeepsToTheClockOfTheRecording) {
  playback_.setSpeed(20.0);  // 2 ms a snapshot: some are left out
  playback_.seek(1);
  playback_.play();
  ASSERT_TRUE(QTest::qWaitFor([this] { return caught_up_ == 1; }, kPatienceMs));
  EXPECT_LT(shown_.size(), 12U);
  EXPECT_TRUE(std::is_sorted(shown_.begin(), shown_.end()));
}

TEST_F(PlaybackTest, GoesOverALoopUntilItIsPaused) {
  playback_.setSpeed(0.0);
  playback_.setLoop(PlayRange{5, 8});
  playback_.play();
  ASSERT_TRUE(QTest::qWaitFor([this] { return shown_.size() > 8; }, kPatienceMs));
  playback_.pause();
  shown_.resize(8);
  EXPECT_EQ(shown_, (std::vector{5, 6, 7, 5, 6, 7, 5, 6}));
  EXPECT_EQ(caught_up_, 0);
}

TEST_F(PlaybackTest, WithoutAPastDoesNothing) {
  for (const auto& history : {std::shared_ptr<RunHistory>(), historyOf(0)}) {
    playback_.setHistory(history);
    playback_.seek(3);
    playback_.stepBack();
    playback_.stepOn();
    playback_.play();
    playback_.toNewest();
    EXPECT_EQ(playback_.index(), 0);
  }
  EXPECT_TRUE(shown_.empty());
}

class TimelineTest : public testing::Test {
 protected:
  TimelineTest() {
    timeline_.resize(216, 20);  // 8 pixels of margin: 2 pixels an observation
    timeline_.setExtent(60, 100);
    QObject::connect(&timeline_, &Timeline::seekWanted, &timeline_,
                     [this](int index) { wanted_.push_back(index); });
  }
  static QPoint at(int index) { return {8 + 2 * index, 10}; }

  Timeline timeline_;
  std::vector<int> wanted_;
};

TEST_F(TimelineTest, AClickAndADragSeek) {
  QTest::mousePress(&timeline_, Qt::LeftButton, {}, at(30));
  QTest::mouseMove(&timeline_, at(45));
  QTest::mouseRelease(&timeline_, Qt::LeftButton, {}, at(45));
  ASSERT_FALSE(wanted_.empty());
  EXPECT_EQ(wanted_.front(), 30);
  EXPECT_EQ(wanted_.back(), 45);
}

TEST_F(TimelineTest, TheKeysSeekWithinWhatIsDone) {
  timeline_.setIndex(59);
  QTest::keyClick(&timeline_, Qt::Key_Right);
  timeline_.setIndex(60);
  for (const auto key : {Qt::Key_Right, Qt::Key_Left, Qt::Key_PageUp, Qt::Key_Home, Qt::Key_End}) {
    QTest::keyClick(&timeline_, key);
  }
  EXPECT_EQ(wanted_, (std::vector{60, 60, 59, 40, 1, 60}));
}

/// A recording of frames 100 to 300, of which a run took 200 to 300: the right half of the strip.
TEST_F(TimelineTest, ItsHandlesTrimTheRecording) {
  std::vector<std::pair<int, int>> trims;
  QObject::connect(&timeline_, &Timeline::trimWanted, &timeline_,
                   [&](int from, int to) { trims.emplace_back(from, to); });
  timeline_.setTrim(TimelineTrim{100, 300, 200, 300});
  timeline_.beginTrimmed();
  const auto below = [](int x) { return QPoint(8 + x, 18); };
  QTest::mousePress(&timeline_, Qt::LeftButton, {}, below(100));
  QTest::mouseMove(&timeline_, below(50));
  QTest::mouseRelease(&timeline_, Qt::LeftButton, {}, below(50));
  QTest::mousePress(&timeline_, Qt::LeftButton, {}, below(200));
  QTest::mouseRelease(&timeline_, Qt::LeftButton, {}, below(10));  // not before its beginning
  EXPECT_EQ(trims, (std::vector<std::pair<int, int>>{{150, 300}, {150, 151}}));
  EXPECT_TRUE(wanted_.empty());
  QTest::mouseClick(&timeline_, Qt::LeftButton, {}, {8 + 100 + 50, 10});
  EXPECT_EQ(wanted_, std::vector{50}) << "the strip is that of the run";
}

TEST_F(TimelineTest, BeforeARunThereIsNothingToSeek) {
  timeline_.clear();
  EXPECT_FALSE(timeline_.isEnabled());
  timeline_.setTrim(TimelineTrim{0, 100, 0, 100});
  EXPECT_TRUE(timeline_.isEnabled());
  QTest::mouseClick(&timeline_, Qt::LeftButton, {}, at(30));
  QTest::keyClick(&timeline_, Qt::Key_Right);
  EXPECT_TRUE(wanted_.empty());
}

TEST_F(TimelineTest, ShiftAndDragChooseALoop) {
  std::vector<std::optional<PlayRange>> loops;
  QObject::connect(&timeline_, &Timeline::loopWanted, &timeline_,
                   [&](const std::optional<PlayRange>& loop) { loops.push_back(loop); });
  QTest::mousePress(&timeline_, Qt::LeftButton, Qt::ShiftModifier, at(50));
  QTest::mouseRelease(&timeline_, Qt::LeftButton, Qt::ShiftModifier, at(20));
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0]->first, 20);
  EXPECT_EQ(loops[0]->last, 50);
  QTest::mousePress(&timeline_, Qt::LeftButton, Qt::ShiftModifier, at(50));
  QTest::mouseRelease(&timeline_, Qt::LeftButton, Qt::ShiftModifier, at(50));
  EXPECT_FALSE(loops.back());
  EXPECT_TRUE(wanted_.empty());
}

TEST_F(TimelineTest, BookmarksAreFoundOneAfterAnother) {
  EXPECT_FALSE(timeline_.nextBookmark());
  for (const int index : {40, 10, 25, 25}) timeline_.toggleBookmark(index);  // 25: on, and off
  timeline_.setIndex(10);
  EXPECT_EQ(timeline_.nextBookmark(), 40);
  timeline_.setIndex(40);
  EXPECT_EQ(timeline_.nextBookmark(), 10);
  timeline_.clear();
  timeline_.setExtent(60, 100);
  EXPECT_EQ(timeline_.nextBookmark(), 10);  // they stay from run to run
}

}  // namespace
}  // namespace handmap
