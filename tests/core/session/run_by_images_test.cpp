// A robot on the move that sees with a stereo camera, on wheels that stray.
#include <gtest/gtest.h>

#include "core/rendering/rendered_source.h"
#include "core/session/run_session.h"

namespace handmap {
namespace {

const World kStreet = streetWorld(28);

std::unique_ptr<ObservationSource> drive() {
  SimulationOptions options = atStep({}, 1.0);
  options.odometry_turn_rad_m = toRadians(0.3);
  RenderOptions camera;
  camera.width = 640;
  camera.height = 320;
  return renderedSource(kStreet, options, camera, Looking::Ahead, 3);
}

/// The street turned about the robot.
Map drawnWrong() {
  Map drawing = kStreet.map;
  drawing.uncertainty.position = 4.0;
  const Pose2 turned = *drawing.start * Pose2{0.0, 0.0, toRadians(8.0)} * inverse(*drawing.start);
  for (Building& building : drawing.buildings) {
    Rectangle& house = std::get<Rectangle>(building.shape);
    house.centre = turned.toOuter(house.centre);
    house.heading += turned.heading;
  }
  return drawing;
}

struct Shown {
  double off_m = 0.0;  ///< at the last of `observations`
  double odometry_off_m = 0.0;
};

Shown shown(const Map& drawing, const RunSettings& settings, int observations) {
  RunSession session(drawing, drive(), settings);
  std::shared_ptr<const Snapshot> last;
  for (int i = 0; i < observations; ++i) last = session.step();
  EXPECT_EQ(static_cast<int>(last->trajectory.size()), observations);
  EXPECT_EQ(last->trajectory.back().pose, last->report.pose);
  const auto off = [&](const Pose2& pose) {
    return (pose.position() - last->truth->position()).norm();
  };
  return {off(last->report.pose), off(last->odometry.back().pose)};
}

TEST(RunByImages, ShowsTheWayThatTheyTellBeforeAnythingIsConcluded) {
  const Shown last = shown(drawnWrong(), {}, 40);
  EXPECT_GT(last.odometry_off_m, 3.0);
  EXPECT_LT(last.off_m, 0.3);
}

TEST(RunByImages, IsLedFromAGivenPoseToItsStartByThem) {
  Map drawing = drawnWrong();
  drawing.start = *drawing.start * Pose2{2.0, -2.0, toRadians(12.0)};
  RunSettings settings;
  settings.given_poses = {drive()->info().truth.at(32)};
  const Shown last = shown(drawing, settings, 40);
  EXPECT_GT(last.odometry_off_m, 3.0);
  EXPECT_LT(last.off_m, 1.8);
}

}  // namespace
}  // namespace handmap
