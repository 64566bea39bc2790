// Scans as logs hold them: ranges or points in units that are still to be found out.
#pragma once

#include <string>
#include <vector>

#include "core/logs/log.h"

namespace handmap {

struct RawScan {
  double time = 0.0;
  std::vector<double> ranges;  ///< or
  std::vector<RangePoint> points;
};

struct RawPose {
  double time = 0.0;
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
};

/// What one file holds.
struct RawLog {
  std::string file;
  std::vector<RawScan> scans;
  std::vector<RawPose> poses;
  std::optional<RayAngles> angles;  ///< as the file tells them
  std::optional<double> most_range_m;
  std::optional<double> metres;  ///< a unit, where the file tells it
  std::optional<double> pose_metres;
  std::optional<double> seconds;
  std::optional<double> radians;
};

/// In metres, seconds, radians: as the options say, as the file says, else as the numbers look,
/// which is noted. Ranges become points; where nothing came back there is none. Throws a Question
/// where the directions of ranges are not told.
void addRaw(const RawLog& raw, const LogOptions& options, Log& log);

/// Of common scanners by how many ranges a scan has; nullopt for others.
std::optional<RayAngles> usualAngles(std::size_t ranges);

}  // namespace handmap
