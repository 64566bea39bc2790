// Poses over time, and the TUM text form: time x y z qx qy qz qw.
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/geometry/pose2.h"

namespace handmap {

struct StampedPose {
  double time_s = 0.0;
  Pose2 pose;
};

/// Strictly increasing in time.
class Trajectory {
 public:
  Trajectory() = default;
  /// `source` names the poses in messages. Throws BadInput where time does not increase.
  Trajectory(std::vector<StampedPose> poses, std::string source);

  const std::vector<StampedPose>& poses() const { return poses_; }
  const std::string& source() const { return source_; }
  bool empty() const { return poses_.empty(); }
  /// Interpolated; nullopt more than `tolerance_s` before the first or after the last pose, the
  /// nearest end within it.
  std::optional<Pose2> at(double time_s, double tolerance_s = 0.05) const;

 private:
  std::vector<StampedPose> poses_;
  std::string source_;
};

Trajectory readTum(const std::filesystem::path& path, const std::stop_token& stop = {});
std::string formatTum(const std::vector<StampedPose>& poses);

}  // namespace handmap
