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

RosHeader RosPublisher::header() const { return {rosTimeNow(), topics_.frame, client_->version()}; }

void RosPublisher::publishPose(const Pose2& pose, const std::array<double, 3>& sigma) {
  client_->publish(topics_.pose, poseMessage(header(), pose, sigma));
}

void RosPublisher::publishMap(std::shared_ptr<const Map> map) {
  map_ = std::move(map);
  sendMap();
}

void RosPublisher::sendMap() {
  if (!map_ || !client_->isConnected()) return;
  client_->publish(topics_.grid, gridMessage(header(), *map_));
  client_->publish(topics_.markers, markersMessage(header(), *map_));
}

}  // namespace handmap
