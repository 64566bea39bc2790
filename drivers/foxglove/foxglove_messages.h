// What a run tells Foxglove: JSON of its well-known schemas.
#pragma once

#include <QByteArray>
#include <QString>
#include <cstdint>

#include "core/map/map.h"

namespace handmap {

/// What a channel carries; its schema is JSON Schema text.
struct FoxgloveChannel {
  std::uint32_t id = 0;
  QString topic;
  QString schema_name;
  QString schema;
};

FoxgloveChannel poseChannel(std::uint32_t id, const QString& topic);
FoxgloveChannel sceneChannel(std::uint32_t id, const QString& topic);

/// foxglove.PoseInFrame, in the map frame. `time_s`: since 1970.
QByteArray poseInFrame(double time_s, const Pose2& pose);
/// foxglove.SceneUpdate: an outline for each building, in place of all before.
QByteArray sceneUpdate(double time_s, const Map& map);

}  // namespace handmap
