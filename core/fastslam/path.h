// The poses of a particle. Particles of one ancestor share what they have in common.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "core/recording/trajectory.h"

namespace handmap {

class Path {
 public:
  Path extended(const StampedPose& pose) const {
    Path result;
    result.last_ = std::make_shared<Link>(pose, last_);
    return result;
  }
  std::vector<StampedPose> poses() const {
    std::vector<StampedPose> poses;
    for (const Link* link = last_.get(); link; link = link->before.get()) {
      poses.push_back(link->pose);
    }
    std::reverse(poses.begin(), poses.end());
    return poses;
  }

 private:
  struct Link {
    StampedPose pose;
    std::shared_ptr<Link> before;

    Link(const StampedPose& with, std::shared_ptr<Link> after)
        : pose(with), before(std::move(after)) {}
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;
    /// A chain that nobody else holds is taken down link by link: recursion would overflow the
    /// stack.
    ~Link() {
      while (before && before.use_count() == 1) before = std::move(before->before);
    }
  };
  std::shared_ptr<Link> last_;
};

}  // namespace handmap
