// Pictures of a world, as a stereo camera on a robot takes them.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/rendering/scene.h"

namespace handmap {

struct StereoImages {
  cv::Mat left;  ///< 8 bit, three channels (BGR) with RenderOptions::colour, else one
  cv::Mat right;
};

/// What the pixels of the left image really show, at their centres.
struct ImageTruth {
  cv::Mat1b labels;  ///< Label
  cv::Mat1f depth;   ///< metres along the optical axis, infinite for the sky and far trees
};

/// Same seed, same bytes, on any number of threads.
class Renderer {
 public:
  /// `seed` is that of the sensor's noise. Throws BadInput for options that cannot be.
  Renderer(const RenderOptions& options, std::uint64_t seed);

  const StereoCamera& camera() const { return camera_; }
  /// What can be seen from about `pose`: all views of a stop share it.
  Scene sceneAt(const World& world, const Pose2& pose, double time_s) const;

  /// `frame` and `view` number the pictures: each has noise of its own.
  StereoImages images(const Scene& scene, const Pose2& pose, double pan, std::uint32_t frame,
                      std::uint32_t view) const;
  ImageTruth truth(const Scene& scene, const Pose2& pose, double pan) const;

 private:
  RenderOptions options_;
  std::uint64_t seed_;
  StereoCamera camera_;
};

}  // namespace handmap
