// Which topic of a bag serves as what: proposed by names and types, or as a person says.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "core/bags/bag.h"

namespace handmap {

/// Numbers of topics. A camera serves with both its images and what both camera infos say.
struct BagPlan {
  std::optional<std::size_t> left, right, left_info, right_info;
  std::optional<std::size_t> ranges;  ///< a LaserScan or a PointCloud2
  std::optional<std::size_t> odometry, truth;
  std::optional<std::size_t> frames, fixed_frames;  ///< /tf, /tf_static
  /// Where the ranges (without any: the camera) are measured from, in the robot's frame, as a
  /// person says; absent: as the frames tell.
  std::optional<Eigen::Isometry3d> sensor;

  bool hasCamera() const { return left && right && left_info && right_info; }
  bool seesAnything() const { return hasCamera() || ranges; }
  /// "left", "scan" …; empty where it does not serve.
  std::string roleOf(std::size_t topic, const Bag& bag) const;
};

/// Role (left, right, scan, points, odometry, truth) → topic, or "none"; "sensor" → its place, as
/// parseSensorPlace() takes it.
using ToldTopics = std::map<std::string, std::string>;

/// Whether the type of a topic lets it.
bool canServe(const BagTopic& topic, const std::string& role);

/// Throws BadInput for a topic that is not there or of a type that cannot serve so, Usage for a
/// place that is none.
BagPlan planOf(const Bag& bag, const ToldTopics& told);

}  // namespace handmap
