// The paper's robot without hardware: it stops, its head looks around, its cameras take a pair at
// each pan. The pictures are rendered.
#include <QTimer>
#include <algorithm>
#include <atomic>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/recording/calibration.h"
#include "core/recording/recording.h"
#include "core/rendering/rendered_source.h"
#include "core/session/run_session.h"
#include "drivers/live/live_source.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

constexpr int kStops = 2;

/// Where the robot is and where its head looks; lives in the thread of the rig.
struct Stage {
  std::vector<Observation> stops;
  std::size_t stop = 0;
  double way = 0.0;  ///< from the stop before to this one
  double pan = 0.0;
};

class StageWheels : public OdometrySensor {
 public:
  StageWheels(std::shared_ptr<Stage> stage, RigClock clock)
      : stage_(std::move(stage)), clock_(std::move(clock)) {
    connect(&timer_, &QTimer::timeout, this, [this] {
      Stage& s = *stage_;
      s.way = std::min(1.0, s.way + 0.1);
      const Pose2 here = s.stops[s.stop].odometry;
      const Pose2 before = s.stop == 0 ? here : s.stops[s.stop - 1].odometry;
      Q_EMIT moved(clock_(), interpolated(before, here, s.way));
    });
  }
  void open() override { timer_.start(20); }
  void close() override { timer_.stop(); }

 private:
  std::shared_ptr<Stage> stage_;
  RigClock clock_;
  QTimer timer_;
};

class StageHead : public PanTiltHead {
 public:
  explicit StageHead(std::shared_ptr<Stage> stage) : stage_(std::move(stage)) {}
  void open() override { Q_EMIT stateChanged(DeviceState::Ready, {}); }
  void close() override {}
  void halt() override { ++halts; }
  void lookAt(double pan, double tilt) override {
    if (pan == 0.0 && stage_->stop + 1 < stage_->stops.size()) {  // it looked around: on it goes
      ++stage_->stop;
      stage_->way = 0.0;
    }
    QTimer::singleShot(60, this, [this, pan, tilt] {
      stage_->pan = pan;
      Q_EMIT arrived(pan, tilt);
    });
  }
  inline static std::atomic<int> halts = 0;

 private:
  std::shared_ptr<Stage> stage_;
};

class StageCamera : public PairCamera {
 public:
  StageCamera(std::shared_ptr<Stage> stage, RigClock clock)
      : stage_(std::move(stage)), clock_(std::move(clock)) {
    connect(&timer_, &QTimer::timeout, this, [this] {
      for (const View& view : stage_->stops[stage_->stop].views) {
        if (view.pan == stage_->pan) Q_EMIT pairTaken(clock_(), view.left, view.right);
      }
    });
  }
  void open() override { timer_.start(40); }
  void close() override { timer_.stop(); }

 private:
  std::shared_ptr<Stage> stage_;
  RigClock clock_;
  QTimer timer_;
};

RenderOptions smallCamera() {
  RenderOptions options;
  options.width = 320;
  options.height = 240;
  options.mount.pitch = 0.03;
  return options;
}

/// What the robot sees at its first stops.
std::vector<Observation> renderedStops(const World& world) {
  const auto source = renderedSource(world, SimulationOptions(), smallCamera(), Looking::Around, 3);
  std::vector<Observation> stops;
  for (int i = 0; i < kStops; ++i) stops.push_back(source->next().value());
  return stops;
}

Rig stopAndLook(const test::TemporaryFolder& folder, const std::vector<Observation>& stops) {
  Rig rig;
  rig.name = "stage";
  rig.camera = CameraRig{};
  rig.camera->left = "rendered";
  rig.camera->mount = cameraOf(smallCamera()).mount;
  rig.camera->calibration = folder.write("calib.txt", formatCalibration(cameraOf(smallCamera())));
  rig.head = HeadRig{"stage"};
  rig.odometry = {OdometryRigKind::Lines, "stage", ""};
  rig.stops = StopRig{};
  for (const View& view : stops[0].views) rig.stops->pans.push_back(view.pan);
  rig.stops->standing_s = 0.2;
  return rig;
}

TEST(StopAndLook, EachStopIsOnePanoramaAndLiveEqualsReplay) {
  const test::TemporaryFolder folder;
  const World world = twoRowWorld(3);
  const std::vector<Observation> stops = renderedStops(world);
  LiveJob job;
  job.rig = stopAndLook(folder, stops);
  job.monitor = std::make_shared<RigMonitor>();
  job.record = folder.path() / "run";
  job.make = [&stops](const Rig&, RigMonitor& monitor) {
    const auto stage = std::make_shared<Stage>();
    stage->stops = stops;
    RigDevices devices;
    devices.odometry = std::make_unique<StageWheels>(stage, monitor.clock());
    devices.head = std::make_unique<StageHead>(stage);
    devices.camera = std::make_unique<StageCamera>(stage, monitor.clock());
    return devices;
  };
  RunSettings settings;
  settings.slam.slam_particles = 10;
  settings.threads = 1;
  const int halts = StageHead::halts;

  std::string lived;
  {
    RunSession session(world.map, openLive(job, {}), settings);
    for (int i = 0; i < kStops; ++i) ASSERT_TRUE(session.step());
    job.monitor->end();
    while (session.step()) {
    }
    EXPECT_EQ(session.frames().size(), static_cast<std::size_t>(kStops));
    lived = formatMap(session.refinedMap()) + formatTum(session.trajectory());
  }
  EXPECT_GT(StageHead::halts, halts) << "the end halts the head";

  const Recording recording = openRecording(job.record);
  ASSERT_EQ(recording.rows.size(), 6U * kStops);
  const auto replayed = replay(recording, {});
  for (const Observation& stop : stops) {
    const Observation observation = replayed->next().value();
    EXPECT_TRUE(observation.standing);
    EXPECT_NEAR(observation.odometry.x, stop.odometry.x, 1e-5);
    ASSERT_EQ(observation.views.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(observation.views[i].pan, stop.views[i].pan, 1e-12);
      EXPECT_EQ(cv::norm(observation.views[i].left, stop.views[i].left, cv::NORM_INF), 0.0) << i;
      EXPECT_EQ(cv::norm(observation.views[i].right, stop.views[i].right, cv::NORM_INF), 0.0) << i;
    }
  }
  RunSession again(world.map, replay(recording, {}), settings);
  while (again.step()) {
  }
  EXPECT_EQ(formatMap(again.refinedMap()) + formatTum(again.trajectory()), lived);
}

}  // namespace
}  // namespace handmap
