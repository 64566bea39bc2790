// Stereo pairs of a small world, rendered ray by ray.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/geometry/polygon.h"
#include "core/recording/camera.h"

namespace handmap::test {

/// Upright, textured, from the ground (z = 0) to its height. Robot frame, metres.
struct Screen {
  Segment base;
  double height;
};

struct Scene {
  std::vector<Screen> screens;
  double ground_slope = 0.0;  ///< metres up per metre forward of the robot
};

struct StereoPair {
  cv::Mat left;
  cv::Mat right;
};

/// Like that of the street recording, 1242×375.
inline StereoCamera streetCamera() {
  StereoCamera camera{721.5, 721.5, 609.6, 172.9, 0.537, {}};
  camera.mount.z = 1.65;
  return camera;
}

/// Random dots of a few sizes, so that some are seen from near and some from far; -1 … 1.
inline double texture(double u, double v, std::uint32_t surface) {
  const auto dot = [surface](long i, long j, std::uint32_t octave) {
    auto h = static_cast<std::uint32_t>(i) * 0x9E3779B1U ^
             static_cast<std::uint32_t>(j) * 0x85EBCA77U ^ (surface * 8 + octave) * 0xC2B2AE3DU;
    h = (h ^ (h >> 15)) * 0x2C1B3C6DU;
    h = (h ^ (h >> 12)) * 0x297A2D39U;
    return static_cast<double>((h ^ (h >> 15)) & 0xFFFFU) / 32767.5 - 1.0;
  };
  double sum = 0.0;
  double size = 0.06;
  for (std::uint32_t octave = 0; octave < 3; ++octave, size *= 3.0) {
    const double x = u / size;
    const double y = v / size;
    const auto i = static_cast<long>(std::floor(x));
    const auto j = static_cast<long>(std::floor(y));
    const double a = x - static_cast<double>(i);
    const double b = y - static_cast<double>(j);
    sum += (1 - b) * ((1 - a) * dot(i, j, octave) + a * dot(i + 1, j, octave)) +
           b * ((1 - a) * dot(i, j + 1, octave) + a * dot(i + 1, j + 1, octave));
  }
  return sum / 3.0;
}

/// What one ray sees: 0 … 255.
inline std::uint8_t shade(const Scene& scene, const Eigen::Vector3d& eye,
                          const Eigen::Vector3d& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  double value = 1.0;  // sky
  const double sinking = scene.ground_slope * ray.x() - ray.z();
  if (sinking > 1e-6) {
    nearest = (eye.z() - scene.ground_slope * eye.x()) / sinking;
    value = texture(eye.x() + nearest * ray.x(), eye.y() + nearest * ray.y(), 0);
  }
  for (std::size_t i = 0; i < scene.screens.size(); ++i) {
    const auto& [base, height] = scene.screens[i];
    const Vec2 along = (base.b - base.a).normalized();
    const double towards = cross(ray.head<2>(), along);
    if (std::abs(towards) < 1e-9) continue;
    const double distance = cross(base.a - eye.head<2>(), along) / towards;
    const Eigen::Vector3d hit = eye + distance * ray;
    const double u = (hit.head<2>() - base.a).dot(along);
    if (distance <= 0.0 || distance >= nearest || u < 0.0 || u > base.length() ||
        hit.z() > height) {
      continue;
    }
    nearest = distance;
    value = texture(u, hit.z(), static_cast<std::uint32_t>(i + 1));
  }
  return static_cast<std::uint8_t>(std::clamp(std::lround(128.0 + 110.0 * value), 0L, 255L));
}

/// 8 bit grey. `pan` turns the camera as the pan of a view does.
inline StereoPair render(const Scene& scene, const StereoCamera& camera, double pan = 0.0) {
  const CameraMount& mount = camera.mount;
  const Vec2 heading = unitVector(mount.yaw + pan);
  const Vec2 left = perpendicular(heading);
  const double c = std::cos(mount.pitch);
  const double s = std::sin(mount.pitch);
  const Eigen::Vector3d axis(c * heading.x(), c * heading.y(), -s);
  const Eigen::Vector3d right_axis(-left.x(), -left.y(), 0.0);
  const Eigen::Vector3d down(-s * heading.x(), -s * heading.y(), -c);
  const auto image = [&](double baseline) {
    const Eigen::Vector3d eye = Eigen::Vector3d(mount.x, mount.y, mount.z) + baseline * right_axis;
    cv::Mat1b pixels(375, 1242);
    for (int v = 0; v < pixels.rows; ++v) {
      for (int u = 0; u < pixels.cols; ++u) {
        pixels(v, u) = shade(
            scene, eye,
            axis + (u - camera.cx) / camera.fx * right_axis + (v - camera.cy) / camera.fy * down);
      }
    }
    return pixels;
  };
  return {image(0.0), image(camera.baseline)};
}

}  // namespace handmap::test
