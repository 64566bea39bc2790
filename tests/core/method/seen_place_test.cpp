#include "core/method/seen_place.h"

#include <gtest/gtest.h>

#include "core/method/pose_trust.h"
#include "core/session/run_session.h"
#include "core/simulation/simulated_source.h"

namespace handmap {
namespace {

/// Once along a way of a kilometre, and what was seen at its observations.
class Drive {
 public:
  explicit Drive(std::uint64_t seed)
      : tape_(std::make_shared<Tape>(simulate(loopWorld(3), laserOnTheMove(2.0), seed),
                                     PerceptionOptions{}, TapeLimits::toDoAgain())) {
    while (tape_->end() < 150) tape_->take(tape_->end(), {});
    SharedListWriter<StampedPose> way;
    for (std::size_t i = 0; i < tape_->end(); ++i) way.push_back(tape_->info().truth[i]);
    way_ = way.share();
  }
  Pose2 poseAt(std::size_t n) const { return way_[n].pose; }
  SeenPlace seenAt(const Pose2& pose) const { return {*tape_, way_, pose}; }
  const std::vector<RangePoint>& looksFrom(std::size_t n) const {
    return tape_->at(n)->percept.points;
  }
  double range_m() const { return tape_->info().range_limit_m; }

 private:
  std::shared_ptr<Tape> tape_;
  SharedList<StampedPose> way_;
};

TEST(SeenPlace, KnowsWhatItSawBeforeAndRefutesWhatItDidNot) {
  const Drive before(1);
  const Drive now(2);
  int known = 0;
  int refuted = 0;
  for (std::size_t n = 0; n + 20 < 150; n += 10) {
    const SeenPlace place = before.seenAt(before.poseAt(n) * Pose2{1.0, 0.5, toRadians(5.0)});
    known += place.isRefutedBy(now.looksFrom(n), now.range_m()) ? 0 : 1;
    refuted += place.isRefutedBy(now.looksFrom(n + 20), now.range_m()) ? 1 : 0;  // 40 m on
  }
  EXPECT_EQ(known, 13);
  EXPECT_GE(refuted, 10) << "the others are among like houses";
}

TEST(SeenPlace, WhereNobodyLookedRefutesNothing) {
  const Drive before(1);
  const SeenPlace nowhere = before.seenAt({-500.0, 0.0, 0.0});
  EXPECT_FALSE(nowhere.isRefutedBy(before.looksFrom(5), before.range_m()));
  EXPECT_FALSE(before.seenAt(before.poseAt(5)).isRefutedBy({}, before.range_m()));
}

/// A run that is said to begin where it does not is lost until somebody says where it was.
TEST(SeenPlace, ARunWhoseStartIsRefutedIsLost) {
  const Drive before(1);
  Map drawing = loopWorld(3).map;
  const auto begin = [&](const Pose2& start, std::vector<StampedPose> given) {
    drawing.start = start;
    RunSettings settings;
    settings.seen_at_start = std::make_shared<SeenPlace>(before.seenAt(start));
    settings.given_poses = std::move(given);
    RunSession session(drawing, simulate(loopWorld(3), laserOnTheMove(2.0), 2), settings);
    session.step();
    return session.step()->report;
  };
  const Pose2 elsewhere = before.poseAt(20);
  EXPECT_EQ(certaintyOf(begin(before.poseAt(0), {})).kind, Certainty::Sure);
  const FrameReport refuted = begin(elsewhere, {});
  EXPECT_TRUE(refuted.start_refuted);
  EXPECT_EQ(certaintyOf(refuted).kind, Certainty::Lost);
  const FrameReport told = begin(elsewhere, {{refuted.time_s, before.poseAt(1)}});
  EXPECT_FALSE(told.start_refuted);
  EXPECT_LT(certaintyOf(told).within_m, 7.0) << "as sure as a hand";
}

}  // namespace
}  // namespace handmap
