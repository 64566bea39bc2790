// Messages of a ROS that is not there, as a rosbridge sends them; with typed arrays (see RFC 8746),
// which in JSON become lists.
#pragma once

#include <QCborMap>
#include <span>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/geometry/pose2.h"
#include "core/recording/camera.h"
#include "core/recording/observation.h"
#include "drivers/rosbridge/ros_client.h"

namespace handmap::emulated {

QCborMap odometry(double stamp_s, const Pose2& pose, RosVersion version);
/// Over a whole turn from -π, with infinity where nothing is.
QCborMap laserScan(double stamp_s, const std::vector<float>& ranges, RosVersion version);
QCborMap pointCloud(double stamp_s, std::span<const RangePoint> points, RosVersion version);
QCborMap compressedImage(double stamp_s, const QByteArray& file, RosVersion version);
/// Grey, a byte a pixel.
QCborMap image(double stamp_s, const cv::Mat& grey, RosVersion version);
/// Of one camera of a rectified pair; `baseline`: metres that it stands to the right of the left
/// one.
QCborMap cameraInfo(const cv::Size& size, const StereoCamera& camera, double baseline,
                    RosVersion version);

}  // namespace handmap::emulated
