// How sure the drawer is of where the robot starts: the member "handmap:start_uncertainty" of a
// map, {"position_m": σ of x and of y, "heading_deg": σ}.
#pragma once

#include <optional>

#include "core/map/map.h"

namespace handmap {

inline constexpr auto kStartUncertaintyKey = "handmap:start_uncertainty";

/// One σ.
struct StartUncertainty {
  double position = 0.0;  ///< of x and of y, metres
  double heading = 0.0;   ///< radians
  bool operator==(const StartUncertainty&) const = default;
};

/// nullopt: not said. Throws BadInput "SOURCE: handmap:start_uncertainty…: found …" for a member
/// that does not say it.
std::optional<StartUncertainty> startUncertaintyOf(const UnknownMembers& members,
                                                   const std::string& source = "map");
/// nullopt takes it away.
void setStartUncertainty(UnknownMembers& members,
                         const std::optional<StartUncertainty>& uncertainty);

}  // namespace handmap
