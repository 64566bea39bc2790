#include "drivers/rosbridge/ros_publisher.h"

#include <utility>

namespace handmap {

RosPublisher::RosPublisher(std::shared_ptr<RosbridgeClient> client, RosTopics topics)
    : client_(std::move(client)), topics_(std::move(topics)) {
  client_->advertise(
      topics_.pose, {QStringLiteral("geometry_msgs"), QStringLiteral("PoseWithCovarianceStamped")});
  client_->advertise(topics_.grid, {QStringLiteral("nav_msgs"), QStringLiteral("OccupancyGrid")});
  client_->advertise(topics_.markers,
                     {QStringLiteral("visualization_msgs"), QStringLiteral("MarkerArray")});
  connect(client_.get(), &RosbridgeClient::connected, this, &RosPublisher::sendMap);
  client_->open();
}

RosPublisher::~RosPublisher() { client_->close(); }

RosHeader RosPublisher::header(double time_s) const {
  return {rosTimeOf(time_s), topics_.frame, client_->version()};
}

void RosPublisher::publishPose(double time_s, const Pose2& pose,
                               const std::array<double, 3>& sigma) {
  client_->publish(topics_.pose, poseMessage(header(time_s), pose, sigma));
}

void RosPublisher::publishMap(double time_s, std::shared_ptr<const Map> map) {
  map_ = std::move(map);
  map_time_s_ = time_s;
  sendMap();
}

void RosPublisher::sendMap() {
  if (!map_ || !client_->isConnected()) return;
  client_->publish(topics_.grid, gridMessage(header(map_time_s_), *map_));
  client_->publish(topics_.markers, markersMessage(header(map_time_s_), *map_));
}

}  // namespace handmap
