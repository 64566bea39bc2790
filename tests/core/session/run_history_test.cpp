#include "core/session/run_history.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

Snapshot snapshotOf(int index, int image_bytes = 0) {
  Snapshot snapshot;
  snapshot.index = index;
  snapshot.report.frame = 10 * index;
  snapshot.report.time_s = 0.1 * index;
  snapshot.pictured = snapshot.report.frame;
  if (image_bytes > 0) snapshot.image = cv::Mat1b::zeros(1, image_bytes);
  return snapshot;
}

TEST(RunHistory, GivesBackWhatItWasGiven) {
  RunHistory history;
  EXPECT_TRUE(history.empty());
  EXPECT_FALSE(history.at(3));
  for (const int index : {1, 2, 4, 5}) history.add(snapshotOf(index));  // 3 was skipped
  EXPECT_EQ(history.first(), 1);
  EXPECT_EQ(history.newest(), 5);
  EXPECT_EQ(history.at(2)->index, 2);
  EXPECT_EQ(history.at(3)->index, 2);
  EXPECT_EQ(history.at(0)->index, 1);
  EXPECT_EQ(history.at(99)->index, 5);
  EXPECT_EQ(history.indexAt(0.45), 4);
  EXPECT_EQ(history.indexAt(-1.0), 1);
  EXPECT_EQ(history.indexAt(9.0), 5);
}

TEST(RunHistory, WhatTheEndChangesTakesThePlaceOfTheLast) {
  RunHistory history;
  history.add(snapshotOf(1));
  Snapshot end = snapshotOf(1);
  end.report.visible_buildings = 7;
  history.add(end);
  EXPECT_EQ(history.at(1)->report.visible_buildings, 7);
}

TEST(RunHistory, KeepsNothingThatIsMadeForALook) {
  int made = 0;
  Snapshot snapshot = snapshotOf(1);
  snapshot.map = Lazy<Map>([&made] {
    ++made;
    return Map();
  });
  RunHistory history;
  history.add(snapshot);
  snapshot.map.get();
  history.at(1)->map.get();
  history.at(1)->map.get();
  EXPECT_EQ(made, 3);  // each its own: what is in the history was never read
}

TEST(RunHistory, BorrowsPicturesOfAnotherRun) {
  RunHistory before;
  RunHistory again;
  for (int index = 1; index <= 3; ++index) {
    before.add(snapshotOf(index, 100));
    again.add(snapshotOf(index));
  }
  again.add(snapshotOf(4, 50));
  again.borrowPictures(before);
  EXPECT_EQ(again.at(2)->image.cols, 100);
  EXPECT_EQ(again.at(4)->image.cols, 50);
}

TEST(RunHistory, IsBounded) {
  RunHistory history({.snapshots = 100, .picture_bytes = 50'000});
  for (int index = 1; index <= 10'000; ++index) history.add(snapshotOf(index, 1000));
  EXPECT_EQ(history.newest(), 10'000);
  EXPECT_EQ(history.first(), 1);
  int before = 0;
  int kept = 0;
  for (int index = 1; index <= 10'000; ++index) {
    const auto snapshot = history.at(index);
    EXPECT_LE(snapshot->index, index);
    EXPECT_GT(snapshot->index, index - 256);
    EXPECT_LE(snapshot->pictured, snapshot->report.frame);
    EXPECT_FALSE(snapshot->image.empty());
    if (snapshot->index != before) ++kept;
    before = snapshot->index;
  }
  EXPECT_LE(kept, 100);
  EXPECT_GT(kept, 30);
}

}  // namespace
}  // namespace handmap
