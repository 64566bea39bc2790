// A robot that sees nothing but points that it follows, on wheels that stray.
#include <gtest/gtest.h>

#include "core/session/run_session.h"
#include "core/simulation/feature_source.h"

namespace handmap {
namespace {

TEST(RunByTracks, TheirNumbersTellTheWay) {
  const World street = streetWorld(28);
  SimulationOptions options = drivingPastFeatures(1.0);
  options.odometry_turn_rad_m = toRadians(0.1);
  auto source = simulateFeatures(street, options, {.tracks = 50.0}, 5);
  Map drawing = street.map;
  drawing.uncertainty.position = 4.0;
  RunSession session(drawing, std::move(source), {});
  std::shared_ptr<const Snapshot> last;
  while (const auto next = session.step()) last = next;
  ASSERT_TRUE(last);
  const auto off = [&](const Pose2& pose) {
    return (pose.position() - last->truth->position()).norm();
  };
  EXPECT_GT(off(last->odometry.back().pose), 5.0);
  EXPECT_LT(off(last->report.pose), 1.0);
  EXPECT_GT(last->report.within[0], 0.5);
}

}  // namespace
}  // namespace handmap
