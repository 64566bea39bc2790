// Tells ROS of a run and hears where a person says that the robot is.
#pragma once

#include <memory>
#include <optional>

#include "drivers/rosbridge/ros_publications.h"

namespace handmap {

struct RosTopics {
  QString pose = QStringLiteral("/handmap/pose");
  QString grid = QStringLiteral("/handmap/map");
  QString markers = QStringLiteral("/handmap/buildings");
  QString transforms = QStringLiteral("/tf");
  QString diagnostics = QStringLiteral("/diagnostics");
  QString given_pose = QStringLiteral("/initialpose");
  QString frame = QStringLiteral("map");
};

/// Times are seconds since 1970 of the robot's clock, to which what is told belongs. Lives in the
/// thread of its client. What is published while there is no connection is lost, but for the map:
/// it is sent again when there is one, and kept there for who comes later.
class RosPublisher : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RosPublisher)
 public:
  explicit RosPublisher(std::shared_ptr<RosClient> client, RosTopics topics = {});
  ~RosPublisher() override;

  struct Transform {
    QString parent;
    QString child;
    Pose2 pose;
  };

  void publishPose(double time_s, const Pose2& pose, const Eigen::Matrix3d& covariance);
  void publishTransforms(double time_s, const std::vector<Transform>& transforms);
  void publishDiagnostic(double time_s, const RosDiagnostic& diagnostic);
  /// Of a map that differs from the one before; the grid goes where it differs itself.
  void publishMap(double time_s, std::shared_ptr<const Map> map);

 Q_SIGNALS:
  /// In the frame of the map, by /initialpose.
  void poseGiven(const handmap::Pose2& pose);

 private:
  RosHeader header(double time_s) const;
  void take(const RosValue& message);
  void sendMap();
  void sendGrid();

  std::shared_ptr<RosClient> client_;
  RosTopics topics_;
  std::shared_ptr<const Map> map_;
  std::optional<OccupancyGrid> grid_;
  double map_time_s_ = 0.0;
};

}  // namespace handmap
