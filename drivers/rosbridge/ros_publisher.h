// Tells ROS of a run, over rosbridge.
#pragma once

#include <memory>

#include "drivers/rosbridge/ros_publications.h"

namespace handmap {

struct RosTopics {
  QString pose = QStringLiteral("/handmap/pose");
  QString grid = QStringLiteral("/handmap/map");
  QString markers = QStringLiteral("/handmap/buildings");
  QString frame = QStringLiteral("map");
};

/// Times are seconds since 1970 of the robot's clock, to which what is told belongs. Lives in the
/// thread of its client. What is published while there is no connection is not lost but for poses:
/// the map is sent again when there is one.
class RosPublisher : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RosPublisher)
 public:
  explicit RosPublisher(std::shared_ptr<RosbridgeClient> client, RosTopics topics = {});
  ~RosPublisher() override;

  void publishPose(double time_s, const Pose2& pose, const std::array<double, 3>& sigma);
  void publishMap(double time_s, std::shared_ptr<const Map> map);

 private:
  RosHeader header(double time_s) const;
  void sendMap();

  std::shared_ptr<RosbridgeClient> client_;
  RosTopics topics_;
  std::shared_ptr<const Map> map_;
  double map_time_s_ = 0.0;
};

}  // namespace handmap
