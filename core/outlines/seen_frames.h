// What the observations of a run saw, thinned and kept for as long as the run: the drawn outlines
// are fitted to it on whatever way turns out to be the best. It takes no more memory after hours
// than after some kilometres.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/outlines/constants.h"
#include "core/perception/scan.h"

namespace handmap {

/// What came back along one ray, by the height above the ground at which it met something.
enum class Echo : std::uint8_t {
  Tall,    ///< as high as walls and little else is
  Low,     ///< hedges, cars, fences
  Ground,  ///< nothing but that the ray got so far
  Silent,  ///< nothing came back where something might have, up to the range
};

struct SeenRay {
  float bearing = 0.0F;  ///< robot frame, radians
  float range = 0.0F;    ///< metres
  /// Of how many rays that tell the same (direction, height) of a frame it is one: 1 / their
  /// number.
  float share = 1.0F;
  Echo echo = Echo::Tall;
};

struct SeenFrame {
  std::size_t observation = 0;                       ///< index of it among those of the run
  std::shared_ptr<const std::vector<SeenRay>> rays;  ///< shared by all copies, in any thread
  float looks = 1.0F;                                ///< it stands for so many, the rest let go
};

class SeenFrames {
 public:
  /// With more than `most_rays` every second frame is let go, and half as many are kept from then,
  /// which tell as much together: after a kilometre or two of a planar scanner. What is concluded
  /// takes 100 bytes a ray for a moment.
  explicit SeenFrames(double range_limit_m, std::size_t most_rays = 1'000'000)
      : range_limit_m_(range_limit_m), most_rays_(most_rays) {}

  /// The observations in their order; one that was made where the last kept one was is let go.
  /// `points`: as they came, robot frame; empty with images.
  void add(std::size_t observation, const Pose2& odometry, const Scan& scan,
           const std::vector<RangePoint>& points);

  const std::vector<SeenFrame>& frames() const { return frames_; }
  double rangeLimit() const { return range_limit_m_; }

 private:
  void addSilent(const std::vector<float>& bearings);
  void thinOut();

  double range_limit_m_;
  std::size_t most_rays_;
  std::size_t rays_ = 0;
  double step_m_ = outlines::kFrameStep_m;  ///< between frames that are kept
  std::vector<SeenFrame> frames_;
  Pose2 last_;          ///< odometry of the last frame
  Pose2 looked_;        ///< and of the last one that would do for a frame
  float looks_ = 0.0F;  ///< since the last frame
};

}  // namespace handmap
