// What kind of thing a return is from, by the shape of all that was seen around it: walls are
// straight and thin, hedges and fences long but thick, crowns and cars ragged.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/outlines/constants.h"
#include "core/outlines/seen_frames.h"
#include "core/perception/range_noise.h"

namespace handmap {

enum class Structure : std::uint8_t { Straight, Linear, Ragged };

/// A ray in the map.
struct PlacedRay {
  float x = 0.0F;  ///< of the robot
  float y = 0.0F;
  float dx = 0.0F;  ///< unit vector
  float dy = 0.0F;
  float range = 0.0F;
  float share = 1.0F;
  Echo echo = Echo::Tall;
  Structure structure = Structure::Ragged;
  float nx = 0.0F;  ///< across what is straight or linear, unit vector
  float ny = 0.0F;
  Vec2 end() const { return {x + range * dx, y + range * dy}; }
};

/// What all frames saw together, from where they were.
struct PlacedRays {
  std::vector<PlacedRay> rays;
  std::vector<std::size_t> frame_begin;  ///< index of the first ray of each frame, and the end
  RangeNoise noise{0.05, 0.0008, 0.0};   ///< as it shows
  double straight = 0.0;  ///< share of the tall returns that are from straight things

  /// Whether walls can be told from the rest: not from few or very noisy returns.
  bool showsStructure() const { return straight > outlines::kStructured; }
};

/// `poses`: of all observations. Tells structure and noise from each other: what is straight shows
/// how far single returns are off, and that shows how thick a straight thing may look.
/// Where `stop` is requested the rest is left out.
PlacedRays placeRays(std::span<const SeenFrame> seen, const std::vector<Pose2>& poses,
                     const std::stop_token& stop = {});
inline PlacedRays placeRays(const SeenFrames& seen, const std::vector<Pose2>& poses,
                            const std::stop_token& stop = {}) {
  return placeRays(seen.frames(), poses, stop);
}

}  // namespace handmap
