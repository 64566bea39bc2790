// Where the frames of a robot are in each other, as /tf and /tf_static tell.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <Eigen/Geometry>

namespace handmap {

class FrameTree {
 public:
  /// The first pose told of a frame stays: what holds sensors does not move.
  void add(const std::string& parent, const std::string& child, const Eigen::Isometry3d& pose);
  bool has(const std::string& frame) const;
  /// The pose of `frame` in `base`; nullopt where nothing connects them.
  std::optional<Eigen::Isometry3d> poseIn(const std::string& base, const std::string& frame) const;

 private:
  struct Joint {
    std::string parent;
    Eigen::Isometry3d pose;
  };
  /// Of the frame and all above it: its pose in each.
  std::map<std::string, Eigen::Isometry3d> above(const std::string& frame) const;

  std::map<std::string, Joint> joints_;  ///< by child
};

}  // namespace handmap
