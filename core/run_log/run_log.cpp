#include "core/run_log/run_log.h"

#include <fmt/format.h>

#include "core/bags/mcap_writer.h"
#include "core/bags/ros_definitions.h"
#include "core/map/map_io.h"
#include "core/run_log/ros_writing.h"
#include "core/run_log/run_part.h"

namespace handmap {

namespace {

constexpr double kLargeEvery_s = 1.0;
constexpr std::string_view kMapFrame = "map";
constexpr std::string_view kRobotFrame = "base_link";
constexpr int kInformation = 20;
constexpr int kWarning = 30;

}  // namespace

struct RunLog::Topics {
  Topics(const std::filesystem::path& its_path, const SourceInfo& its_source)
      : path(its_path),
        writer(runPartOf(its_path)),
        source(its_source),
        frames(add("/tf", "tf2_msgs/msg/TFMessage")),
        pose(add("/pose", "geometry_msgs/msg/PoseStamped")),
        sure_pose(add("/pose_with_covariance", "geometry_msgs/msg/PoseWithCovarianceStamped")),
        odometry(add("/odometry", "nav_msgs/msg/Odometry")),
        truth(add("/truth", "geometry_msgs/msg/PoseStamped")),
        particles(add("/particles", "sensor_msgs/msg/PointCloud2")),
        drawn(add("/drawing", "sensor_msgs/msg/PointCloud2")),
        corrected(add("/corrected", "sensor_msgs/msg/PointCloud2")),
        buildings(add("/buildings", "visualization_msgs/msg/MarkerArray")),
        grid(add("/local_map", "nav_msgs/msg/OccupancyGrid")),
        image(add("/camera/image/compressed", "sensor_msgs/msg/CompressedImage")),
        camera(add("/camera/camera_info", "sensor_msgs/msg/CameraInfo")),
        words(add("/rosout", "rcl_interfaces/msg/Log")),
        numbers(add("/numbers", "handmap_msgs/msg/Numbers")) {}

  std::uint16_t add(const std::string& name, const std::string& type) {
    return writer.addTopic(name, type, rosDefinition(type));
  }
  void write(std::uint16_t topic, const std::string& message) {
    writer.write(topic, time_s, message);
  }
  ros::Stamp in(std::string_view its_frame) const { return {time_s, its_frame}; }

  void writeMap(const Map& map) {
    write(corrected, ros::outlines(in(kMapFrame), map));
    write(buildings, ros::markers(in(kMapFrame), map));
  }

  std::filesystem::path path;
  McapWriter writer;
  SourceInfo source;
  std::uint16_t frames, pose, sure_pose, odometry, truth, particles, drawn, corrected, buildings,
      grid, image, camera, words, numbers;
  Map drawing;
  int frame = -1;
  int pictured = -1;
  double time_s = 0.0;
  double large_s = -1e300;
};

RunLog::RunLog(const std::filesystem::path& path, const Map& drawing, const SourceInfo& source)
    : topics_(std::make_unique<Topics>(path, source)) {
  topics_->drawing = drawing;
  topics_->writer.attach("drawing.handmap", "application/json", 0.0, formatMap(drawing));
}

RunLog::~RunLog() = default;

void RunLog::add(const Snapshot& snapshot) {
  Topics& to = *topics_;
  const FrameReport& report = snapshot.report;
  if (report.frame <= to.frame) return;
  const bool is_first = to.frame < 0;
  to.frame = report.frame;
  to.time_s = report.time_s;
  if (is_first) {
    // Rerun shows what hangs on this frame alone.
    to.write(to.frames, ros::transform(to.in("tf#/"), kMapFrame, {}));
    to.write(to.drawn, ros::outlines(to.in(kMapFrame), to.drawing));
    to.write(to.words, ros::log(to.time_s, kInformation, to.source.name));
  }
  to.write(to.frames, ros::transform(to.in(kMapFrame), kRobotFrame, report.pose));
  to.write(to.pose, ros::pose(to.in(kMapFrame), report.pose));
  to.write(to.sure_pose, ros::poseWithCovariance(to.in(kMapFrame), report));
  to.write(to.odometry, ros::odometry(to.in("odom"), kRobotFrame, snapshot.driven));
  if (snapshot.truth) to.write(to.truth, ros::pose(to.in(kMapFrame), *snapshot.truth));
  if (!snapshot.particles.empty()) {
    to.write(to.particles, ros::particles(to.in(kMapFrame), snapshot.particles));
  }
  to.write(to.numbers, ros::numbers(to.in(kMapFrame), report));
  if (!snapshot.image.empty() && snapshot.pictured != to.pictured) {
    to.pictured = snapshot.pictured;
    to.write(to.image, ros::jpeg(to.in(kRobotFrame), snapshot.image));
    if (to.source.camera) {
      to.write(to.camera,
               ros::cameraInfo(to.in(kRobotFrame), *to.source.camera, snapshot.image.size()));
    }
  }
  if (to.time_s - to.large_s < kLargeEvery_s) return;
  to.large_s = to.time_s;
  if (snapshot.map) to.writeMap(*snapshot.map.again());
  if (snapshot.local_map) {
    to.write(to.grid, ros::grid(to.in(kRobotFrame), snapshot.local_map.again().get()));
  }
}

void RunLog::finish(const Map& refined, const std::vector<StampedPose>& trajectory,
                    const std::vector<RunWarning>& warnings) {
  Topics& to = *topics_;
  to.writeMap(refined);
  for (const RunWarning& warning : warnings) {
    to.write(to.words, ros::log(to.time_s, kWarning, warning.message));
  }
  to.writer.attach("refined.handmap", "application/json", to.time_s, formatMap(refined));
  to.writer.attach("trajectory.tum", "text/plain", to.time_s, formatTum(trajectory));
  to.writer.note("handmap", {{"version", HANDMAP_VERSION},
                             {"recording", to.source.name},
                             {"refinement", refined.refinement}});
  to.writer.finish();
  takePlace(to.path);
}

}  // namespace handmap
