// What a run tells Foxglove: JSON of its well-known schemas.
#pragma once

#include <QByteArray>
#include <QString>
#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/map/map.h"
#include "core/map/occupancy_grid.h"
#include "core/recording/observation.h"

namespace handmap {

/// What a channel carries; its schema is JSON Schema text.
struct FoxgloveChannel {
  std::uint32_t id = 0;
  QString topic;
  QString schema_name;
  QString schema;
};

/// All that there are; a channel's id is its place from 1 on.
enum class FoxgloveTopic { Pose, Buildings, Transforms, Points, Particles, Grid, Image };
std::vector<FoxgloveChannel> foxgloveChannels();

// Times are seconds since 1970; what names no frame is in that of the map.

/// foxglove.PoseInFrame
QByteArray poseInFrame(double time_s, const Pose2& pose);
/// foxglove.SceneUpdate: an outline for each building, in place of all before.
QByteArray sceneUpdate(double time_s, const Map& map);
/// foxglove.FrameTransform
QByteArray frameTransform(double time_s, const std::string& parent, const std::string& child,
                          const Pose2& pose);
/// foxglove.PointCloud: points of the robot's frame, seen from `pose`.
QByteArray pointCloud(double time_s, const Pose2& pose, const std::vector<RangePoint>& points);
/// foxglove.PosesInFrame
QByteArray posesInFrame(double time_s, const std::vector<Pose2>& poses);
/// foxglove.Grid: 1 in a building, 0 elsewhere.
QByteArray gridOf(double time_s, const OccupancyGrid& grid);
/// foxglove.CompressedImage: JPEG.
QByteArray compressedImage(double time_s, const cv::Mat& image);

}  // namespace handmap
