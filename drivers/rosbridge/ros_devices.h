// Devices of a rig whose data come by a bridge of ROS.
#pragma once

#include <array>
#include <deque>
#include <memory>

#include "drivers/device/clock_offset.h"
#include "drivers/device/odometry_stream.h"
#include "drivers/rosbridge/ros_messages.h"
#include "drivers/rosbridge/ros_topic.h"

namespace handmap {

/// nav_msgs/Odometry, and a std_msgs/Empty by which the robot asks its head to look around.
class RosOdometry : public OdometrySensor {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RosOdometry)
 public:
  /// `look`: the topic of the Empty; empty: none.
  RosOdometry(std::shared_ptr<RosClient> client, const QString& topic, QString look,
              RigClock clock);
  ~RosOdometry() override;
  void open() override;
  void close() override;

 private:
  void nameFrames(const RosOdometryMessage& read);

  std::shared_ptr<RosClient> client_;
  QString look_;
  OdometryStream stream_;
  std::optional<OdometryFrames> frames_;  ///< told last
  RosTopic topic_;
};

/// sensor_msgs/LaserScan or sensor_msgs/PointCloud2.
class RosScanner : public RangeSensor {
  Q_OBJECT
 public:
  enum class Kind { LaserScan, PointCloud2 };
  RosScanner(std::shared_ptr<RosClient> client, const QString& topic, Kind kind, RigClock clock);
  void open() override { topic_.open(); }
  void close() override { topic_.close(); }

 private:
  ClockOffset offset_;
  RosTopic topic_;
};

/// Two sensor_msgs/CompressedImage whose stamps are at most 5 ms apart.
class RosCamera : public PairCamera {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RosCamera)
 public:
  /// How they are calibrated: the rig says it, or a sensor_msgs/CameraInfo beside each topic.
  enum class Calibration { OfRig, OfRobot };
  RosCamera(std::shared_ptr<RosClient> client, const QString& left, const QString& right,
            RigClock clock, Calibration calibration = Calibration::OfRig);
  ~RosCamera() override;
  void open() override;
  void close() override;
  int unpaired() const { return unpaired_; }  ///< images whose partner never came

 private:
  using Images = std::deque<RosImageMessage>;
  /// What one of the two says of itself, until both are known.
  struct Info {
    QString topic;
    std::optional<ros::CameraInfo> told;
    QString trouble;
  };
  QString take(Images& own, Images& other, const RosValue& message, double arrival_s);
  void askInfos();
  void askNoMore();
  void describe();
  QString lacking() const;
  void tell();

  std::shared_ptr<RosClient> client_;
  std::array<Info, 2> infos_;  ///< left, right
  bool are_rectified_ = false;
  bool is_described_ = true;
  ClockOffset offset_;
  Images left_images_;
  Images right_images_;
  int unpaired_ = 0;
  ToldState left_state_;
  ToldState right_state_;
  QString left_detail_;
  QString right_detail_;
  RosTopic left_;  // last: they say that they close when they end
  RosTopic right_;
};

}  // namespace handmap
