#include "core/bag_import/frame_tree.h"

#include <algorithm>

namespace handmap {

void FrameTree::add(const std::string& parent, const std::string& child,
                    const Eigen::Isometry3d& pose) {
  constexpr std::size_t kMostFrames = 100'000;
  if (joints_.size() < kMostFrames) joints_.emplace(child, Joint{parent, pose});
}

bool FrameTree::has(const std::string& frame) const {
  return joints_.contains(frame) || std::any_of(joints_.begin(), joints_.end(), [&](const auto& j) {
           return j.second.parent == frame;
         });
}

std::map<std::string, Eigen::Isometry3d> FrameTree::above(const std::string& frame) const {
  std::map<std::string, Eigen::Isometry3d> poses;
  std::string at = frame;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  while (poses.emplace(at, pose).second) {  // a ring ends it, too
    const auto joint = joints_.find(at);
    if (joint == joints_.end()) break;
    pose = joint->second.pose * pose;
    at = joint->second.parent;
  }
  return poses;
}

std::optional<Eigen::Isometry3d> FrameTree::poseIn(const std::string& base,
                                                   const std::string& frame) const {
  const auto of_base = above(base);
  for (const auto& [name, pose] : above(frame)) {
    const auto shared = of_base.find(name);
    if (shared != of_base.end()) return shared->second.inverse() * pose;
  }
  return std::nullopt;
}

}  // namespace handmap
