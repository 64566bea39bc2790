#include "drivers/rosbridge/ros_publisher.h"

#include <utility>

#include "core/base/error.h"
#include "drivers/rosbridge/ros_messages.h"

namespace handmap {

namespace {

RosType rosType(const char* package, const char* name) {
  return {QString::fromLatin1(package), QString::fromLatin1(name)};
}

}  // namespace

RosPublisher::RosPublisher(std::shared_ptr<RosClient> client, RosTopics topics)
    : client_(std::move(client)), topics_(std::move(topics)) {
  using Keep = RosClient::Keep;
  const RosType pose = rosType("geometry_msgs", "PoseWithCovarianceStamped");
  client_->advertise(topics_.pose, pose);
  client_->advertise(topics_.transforms, rosType("tf2_msgs", "TFMessage"));
  client_->advertise(topics_.diagnostics, rosType("diagnostic_msgs", "DiagnosticArray"));
  client_->advertise(topics_.grid, rosType("nav_msgs", "OccupancyGrid"), Keep::Last);
  client_->advertise(topics_.markers, rosType("visualization_msgs", "MarkerArray"), Keep::Last);
  client_->subscribe(topics_.given_pose, pose, [this](const RosValue& message) { take(message); });
  connect(client_.get(), &RosClient::connected, this, [this] {
    sendGrid();
    sendMap();
  });
  client_->open();
}

RosPublisher::~RosPublisher() {
  client_->unsubscribe(topics_.given_pose);
  client_->close();
}

RosHeader RosPublisher::header(double time_s) const {
  return {rosTimeOf(time_s), topics_.frame, client_->version()};
}

void RosPublisher::take(const RosValue& message) {
  const RosPoseMessage given = readPose(message);
  if (given.frame != topics_.frame.toStdString()) {
    message.at("header").fail('"' + given.frame + '"', '"' + topics_.frame.toStdString() + '"');
  }
  Q_EMIT poseGiven(given.pose);
}

void RosPublisher::publishPose(double time_s, const Pose2& pose,
                               const Eigen::Matrix3d& covariance) {
  client_->publish(topics_.pose, poseMessage(header(time_s), pose, covariance));
}

void RosPublisher::publishTransforms(double time_s, const std::vector<Transform>& transforms) {
  std::vector<RosTransform> stamped;
  for (const Transform& transform : transforms) {
    stamped.push_back({rosTimeOf(time_s), transform.parent, transform.child, transform.pose});
  }
  client_->publish(topics_.transforms, transformsMessage(stamped, client_->version()));
}

void RosPublisher::publishDiagnostic(double time_s, const RosDiagnostic& diagnostic) {
  client_->publish(topics_.diagnostics, diagnosticMessage(header(time_s), diagnostic));
}

void RosPublisher::publishMap(double time_s, std::shared_ptr<const Map> map) {
  map_ = std::move(map);
  map_time_s_ = time_s;
  OccupancyGrid grid = occupancyOf(*map_);
  if (grid_ != grid) {
    grid_ = std::move(grid);
    sendGrid();
  }
  sendMap();
}

void RosPublisher::sendGrid() {
  if (!grid_ || !client_->isConnected()) return;
  client_->publish(topics_.grid, gridMessage(header(map_time_s_), *grid_));
}

void RosPublisher::sendMap() {
  if (!map_ || !client_->isConnected()) return;
  client_->publish(topics_.markers, markersMessage(header(map_time_s_), *map_));
}

}  // namespace handmap
