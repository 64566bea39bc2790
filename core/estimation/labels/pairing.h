// One drawn building and one found one: whether they are the same.
#pragma once

#include <optional>

#include "core/estimation/buildings/found_box.h"
#include "core/estimation/drawing/drawing_motion.h"
#include "core/map/map.h"

namespace handmap {

struct PairingOptions {
  double built_on = 0.02;  ///< share of the walls that are of something undrawn; choice
  double heading_sigma = toRadians(3.0);  ///< of a building against the drawing; METHOD.md
};

/// What holds if the two are the same.
struct Pairing {
  double log_likelihood = 0.0;  ///< of the walls seen, where the drawing tells them
  int walls = 0;                ///< of these
  int widths = 0;               ///< axes of which both walls were seen
  DrawingMotion motion;         ///< how the drawing lies
};

/// nullopt where they cannot be the same.
std::optional<Pairing> pairing(const Rectangle& drawn, const Uncertainty& uncertainty,
                               const FoundBox& found, const DrawingMotion& motion,
                               const PairingOptions& options);

}  // namespace handmap
