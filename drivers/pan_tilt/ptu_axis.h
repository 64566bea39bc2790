// One axis of a pan-tilt head as the head itself describes it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/geometry/pose2.h"

namespace handmap {

/// In positions (steps) and positions a second, as the head answers.
struct PtuAxis {
  double resolution_arcsec = 0.0;  ///< a position; differs between heads
  double least = 0.0;
  double most = 0.0;
  double slowest = 0.0;
  double fastest = 0.0;

  double radiansPerPosition() const { return toRadians(resolution_arcsec / 3600.0); }
  double angleOf(double position) const { return position * radiansPerPosition(); }

  /// The nearest that the limits allow; angles a turn apart are the same.
  double positionOf(double angle_rad) const {
    const double asked = angle_rad / radiansPerPosition();
    const double wrapped = normalizedAngle(angle_rad) / radiansPerPosition();
    const double wanted = std::clamp(asked, least, most) == asked ? asked : wrapped;
    return std::clamp(std::round(wanted), least, most);
  }
  double speedOf(double speed_rad_s) const {
    return std::clamp(std::round(speed_rad_s / radiansPerPosition()), std::max(slowest, 1.0),
                      fastest);
  }
  /// What cannot be about this axis; nullopt where all is well.
  std::optional<std::string> fault() const;
};

}  // namespace handmap
