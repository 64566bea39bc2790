// Looking back at a real run: what was shown then is shown again, to the byte.
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/session/run_history.h"
#include "core/session/run_session.h"

namespace handmap {
namespace {

/// All of it that does not depend on a clock.
std::string bytesOf(const Snapshot& snapshot) {
  std::string bytes = formatMap(*snapshot.map) + formatTum(snapshot.trajectory.all()) +
                      formatTum(snapshot.odometry.all());
  const auto add = [&bytes](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  const auto add_image = [&bytes](const cv::Mat& image) {
    for (int row = 0; row < image.rows; ++row) {
      bytes.append(reinterpret_cast<const char*>(image.ptr(row)),
                   static_cast<std::size_t>(image.cols) * image.elemSize());
    }
  };
  add(snapshot.index);
  add(snapshot.report.frame);
  add(snapshot.report.pose);
  add(snapshot.report.pose_sigma);
  add(snapshot.report.within);
  for (const ParticleView& particle : snapshot.particles) {
    add(particle.pose);
    add(particle.weight);
  }
  for (const SwarmView& swarm : snapshot.swarms) {
    for (const Polygon& member : swarm.members) {
      for (const Vec2& corner : member) add(corner);
    }
  }
  add_image(snapshot.local_map.get().cells());
  add_image(snapshot.image);
  add_image(snapshot.disparity);
  return bytes;
}

class Seeking : public testing::Test {
 protected:
  void SetUp() override {
    street_ = std::filesystem::path(HANDMAP_SHARED_DATA) / "street";
    if (!std::filesystem::exists(street_)) GTEST_SKIP() << "needs " << street_;
  }
  Map drawing() const { return readMap(street_ / "sketch-b.handmap"); }
  std::shared_ptr<Tape> tape(SourceKind kind, int every, std::optional<int> to = {}) const {
    ReplayOptions options;
    options.from = 38;
    options.kind = kind;
    options.every = every;
    options.to = to;
    return std::make_shared<Tape>(replay(openRecording(street_), options), PerceptionOptions{},
                                  TapeLimits{1U << 30U, 0});
  }

  std::filesystem::path street_;
};

TEST_F(Seeking, TwoHundredTimesOnAStreetGivesWhatWasPlayed) {
  RunSession session(drawing(), tape(SourceKind::Points, 1), {});
  RunHistory history;
  std::map<int, std::size_t> played;
  while (const auto snapshot = session.step()) {
    history.add(*snapshot);
    played[snapshot->index] = std::hash<std::string>()(bytesOf(*snapshot));
  }
  ASSERT_GT(played.size(), 40U);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> anywhere(history.first(), history.newest());
  for (int i = 0; i < 200; ++i) {
    const int index = anywhere(random);
    EXPECT_EQ(std::hash<std::string>()(bytesOf(*history.at(index))), played.at(index)) << index;
  }
}

TEST_F(Seeking, AlsoToPicturesAndInARunThatIsDoneAgain) {
  const auto images = tape(SourceKind::Images, 4, 120);
  RunHistory histories[2];
  for (RunHistory& history : histories) {
    RunSession session(drawing(), images, {});
    while (const auto snapshot = session.step()) history.add(*snapshot);
  }
  histories[1].borrowPictures(histories[0]);
  ASSERT_GT(histories[0].newest(), 10);
  for (int index = histories[0].first(); index <= histories[0].newest(); ++index) {
    EXPECT_FALSE(histories[1].at(index)->image.empty());
    EXPECT_TRUE(bytesOf(*histories[0].at(index)) == bytesOf(*histories[1].at(index))) << index;
  }
}

}  // namespace
}  // namespace handmap
