#include "core/rendering/renderer.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel.h"
#include "core/rendering/exposure.h"
#include "core/rendering/visibility.h"

namespace handmap {

namespace {

constexpr int kSamples = 2;  // a pixel, along each axis

/// What a pixel sees: each surface once, with the share of the samples that see it.
Colour pixelRadiance(const Scene& scene, const ViewCamera& camera, const Visibility& visibility,
                     int column, int row) {
  struct Part {
    std::int32_t seen;
    int samples;
    double u;
    double v;
  };
  Part parts[kSamples * kSamples];
  int count = 0;
  for (int j = kSamples * row; j < kSamples * (row + 1); ++j) {
    for (int i = kSamples * column; i < kSamples * (column + 1); ++i) {
      const std::int32_t seen = visibility.seen[visibility.index(i, j)];
      Part* const end = parts + count;
      Part* const part = std::find_if(parts, end, [&](const Part& p) { return p.seen == seen; });
      if (part == end) {
        *end = {seen, 1, visibility.pixelOf(i), visibility.pixelOf(j)};
        ++count;
      } else {
        ++part->samples;
      }
    }
  }
  if (count == 1) return scene.radiance(parts[0].seen, camera, column, row);
  Colour sum = Colour::Zero();
  for (int k = 0; k < count; ++k) {
    sum += static_cast<float>(parts[k].samples) *
           scene.radiance(parts[k].seen, camera, parts[k].u, parts[k].v);
  }
  return sum / static_cast<float>(kSamples * kSamples);
}

cv::Mat3f radianceOf(const Scene& scene, const ViewCamera& camera) {
  const Visibility visibility = visibilityOf(scene.model().surfaces, camera, kSamples);
  cv::Mat3f picture(camera.height, camera.width);
  parallelStretches(camera.height, 8, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int column = 0; column < camera.width; ++column) {
        const Colour colour = pixelRadiance(scene, camera, visibility, column, row);
        picture(row, column) = {colour[0], colour[1], colour[2]};
      }
    }
  });
  return picture;
}

}  // namespace

Renderer::Renderer(const RenderOptions& options, std::uint64_t seed)
    : options_(options), seed_(seed), camera_(cameraOf(options)) {}

Scene Renderer::sceneAt(const World& world, const Pose2& pose, double time_s) const {
  return Scene(world, options_.light, pose.position(), time_s);
}

StereoImages Renderer::images(const Scene& scene, const Pose2& pose, double pan,
                              std::uint32_t frame, std::uint32_t view) const {
  ViewCamera camera = viewCamera(camera_, options_.width, options_.height, pose, pan);
  const cv::Mat3f left = radianceOf(scene, camera);
  camera.eye += camera_.baseline * camera.right;
  const cv::Mat3f right = radianceOf(scene, camera);
  const float exposure = static_cast<float>(options_.exposure) * automaticExposure(left);
  const auto develop = [&](const cv::Mat3f& radiance, std::uint32_t picture) {
    return developed(radiance, exposure, options_.colour, options_.noise_sigma, seed_, frame,
                     picture);
  };
  return {develop(left, 2 * view), develop(right, 2 * view + 1)};
}

ImageTruth Renderer::truth(const Scene& scene, const Pose2& pose, double pan) const {
  const ViewCamera camera = viewCamera(camera_, options_.width, options_.height, pose, pan);
  const Visibility visibility = visibilityOf(scene.model().surfaces, camera, 1);
  ImageTruth truth;
  truth.labels.create(camera.height, camera.width);
  truth.depth.create(camera.height, camera.width);
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      const std::size_t i = visibility.index(column, row);
      truth.labels(row, column) =
          static_cast<std::uint8_t>(scene.labelAt(visibility.seen[i], camera, column, row));
      const float inverse = visibility.inverse_depth[i];
      truth.depth(row, column) =
          inverse > 0.0F ? 1.0F / inverse : std::numeric_limits<float>::infinity();
    }
  }
  return truth;
}

}  // namespace handmap
