#include "core/odometry/visual_odometry_source.h"

#include <gtest/gtest.h>

#include "tests/core/base/expect_error.h"
#include "tests/core/odometry/drive.h"
#include "tests/core/recording/example_recording.h"

namespace handmap {
namespace {

using test::viewFrom;
using test::yard;

/// Gives what it is told; an observation without views is a frame that cannot be read.
class ListedSource : public ObservationSource {
 public:
  explicit ListedSource(std::vector<Observation> observations)
      : observations_(std::move(observations)) {
    info_.camera = test::odometryCamera();
    info_.start_odometry = {7, 8, 1};
    info_.odometry = {{0.0, {7, 8, 1}}};
    info_.truth = {{0.0, {1, 2, 3}}};
  }
  const SourceInfo& info() const override { return info_; }
  std::optional<Observation> next() override {
    if (next_ == observations_.size()) return std::nullopt;
    const Observation& observation = observations_[next_++];
    if (observation.views.empty()) throw FrameError(observation.frame, "unreadable");
    return observation;
  }

 private:
  std::vector<Observation> observations_;
  SourceInfo info_;
  std::size_t next_ = 0;
};

Observation observed(int frame, double time_s, std::vector<View> views, bool standing = false) {
  Observation observation;
  observation.frame = frame;
  observation.time_s = time_s;
  observation.standing = standing;
  observation.odometry = {50, 50, 1};
  observation.views = std::move(views);
  return observation;
}

std::unique_ptr<ObservationSource> visual(std::vector<Observation> observations) {
  return withVisualOdometry(std::make_unique<ListedSource>(std::move(observations)));
}

View fog() {
  const cv::Mat image(375, 1242, CV_8UC1, cv::Scalar(120));
  return {0.0, image, image, {}};
}

TEST(VisualOdometrySource, FillsInTheOdometry) {
  const Pose2 second{0.7, 0, 0.03};
  const Pose2 third{1.5, 0.05, 0.05};
  const auto source = visual({observed(3, 0.0, {viewFrom(yard(), {})}), observed(4, 0.1, {}),
                              observed(5, 0.2, {viewFrom(yard(), second)}),
                              observed(6, 0.3, {viewFrom(yard(), third)})});
  EXPECT_EQ(source->info().start_odometry, Pose2{});
  EXPECT_TRUE(source->info().odometry.empty());
  EXPECT_EQ(source->info().truth.size(), 1u);
  const auto first = source->next();
  EXPECT_EQ(first->odometry, Pose2{});
  EXPECT_EQ(first->frame, 3);
  EXPECT_THROW(source->next(), FrameError);
  for (const Pose2& truth : {second, third}) {
    const auto observation = source->next();
    ASSERT_TRUE(observation);
    EXPECT_FALSE(observation->odometry_guessed);
    EXPECT_LT((observation->odometry.position() - truth.position()).norm(), 0.03);
    EXPECT_NEAR(observation->odometry.heading, truth.heading, 0.003);
    EXPECT_GT(observation->read_ms, 0.0);
  }
  EXPECT_FALSE(source->next());
}

TEST(VisualOdometrySource, UsesTheViewAheadOfAStop) {
  const Pose2 second{2.0, 0.1, 0.05};
  const auto stop = [](int frame, const Pose2& pose) {
    return observed(frame, 10.0 * frame, {fog(), viewFrom(yard(), pose, 0.02), fog()}, true);
  };
  std::vector<Observation> stops{stop(0, {}), stop(1, second)};
  for (Observation& observation : stops) {
    observation.views[0].pan = -1.5;
    observation.views[2].pan = 1.5;
  }
  const auto source = visual(stops);
  source->next();
  const auto observation = source->next();
  ASSERT_TRUE(observation);
  EXPECT_LT((observation->odometry.position() - second.position()).norm(), 0.1);
  EXPECT_NEAR(observation->odometry.heading, second.heading, 0.006);
}

TEST(VisualOdometrySource, SaysWhereStopsAreTooFarApart) {
  const test::Scene other{{{{{508, -320}, {508, 30}}, 9.0}}, 0.0};
  const auto source = visual({observed(0, 0.0, {viewFrom(yard(), {})}, true),
                              observed(1, 1.0, {viewFrom(other, {500, 0, 0})}, true)});
  source->next();
  test::expectError(ErrorCode::RunFailed, [&] { source->next(); },
                    {"frame 1", "in common with frame 0", "--every", "--odometry FILE.tum"});
}

TEST(VisualOdometrySource, BelievesASpeedForThreeSeconds) {
  const auto source = visual({observed(0, 0.0, {viewFrom(yard(), {})}),
                              observed(1, 0.5, {viewFrom(yard(), {0.5, 0, 0})}),
                              observed(2, 2.5, {fog()}), observed(3, 4.0, {fog()})});
  source->next();
  source->next();
  const auto guessed = source->next();
  ASSERT_TRUE(guessed);
  EXPECT_TRUE(guessed->odometry_guessed);
  EXPECT_NEAR(guessed->odometry.x, 2.5, 0.1);
  test::expectError(ErrorCode::RunFailed, [&] { source->next(); },
                    {"frame 3", "in common with frame 1"});
}

TEST(VisualOdometrySource, IsTakenWhereThereIsNoOdometry) {
  const test::ExampleRecording example;
  const auto open = [&](const ReplayOptions& options) {
    return replayWithOdometry(openRecording(example.path()), options);
  };
  EXPECT_EQ(open({.from = 2})->info().start_odometry, (Pose2{2, 0, 0}));
  EXPECT_EQ(open({.from = 2, .visual_odometry = true})->info().start_odometry, Pose2{});
  std::filesystem::remove(example.path() / "odometry.tum");
  EXPECT_EQ(open({.from = 2})->info().start_odometry, Pose2{});
  EXPECT_EQ(open({.from = 2})->next()->odometry, Pose2{});
  test::expectBadInput([&] { open({.kind = SourceKind::Points}); }, {"no odometry"});
  test::expectBadInput([&] { open({.kind = SourceKind::Points, .visual_odometry = true}); },
                       {"images for visual odometry"});
  test::expectBadInput(
      [] {
        class Blind : public ObservationSource {
          const SourceInfo& info() const override { return info_; }
          std::optional<Observation> next() override { return std::nullopt; }
          SourceInfo info_;
        };
        withVisualOdometry(std::make_unique<Blind>());
      },
      {"no stereo camera"});
}

}  // namespace
}  // namespace handmap
