// The text files of a drive of KITTI's raw data.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "core/recording/recording.h"

namespace handmap {

/// "2011-09-26 13:04:34.977012964", one a line: seconds since 1970. Throws BadInput.
std::vector<double> readKittiTimestamps(const std::filesystem::path& path);

/// "KEY: 1.0 2.0 …" of each line that holds numbers alone. Throws BadInput.
class KittiCalibration {
 public:
  explicit KittiCalibration(const std::filesystem::path& path);
  /// Throws BadInput where there are not so many.
  const std::vector<double>& numbers(const std::string& key, std::size_t count) const;
  /// Of R and T: where the frame that it is of lies in the other one.
  Eigen::Isometry3d transform() const;

 private:
  std::string file_;
  std::map<std::string, std::vector<double>> entries_;
};

/// Position and heading by GPS and inertial sensors: latitude, longitude and heading (radians, 0
/// east) of a file of `oxts/data`. Throws BadInput.
struct KittiFix {
  double latitude = 0.0;
  double longitude = 0.0;
  double heading = 0.0;
};
KittiFix readKittiFix(const std::filesystem::path& path);

/// Of a file of `velodyne_points/data`, every `stride`th. Throws BadInput.
std::vector<RangePoint> readKittiScan(const std::filesystem::path& path, std::size_t stride);

}  // namespace handmap
