#include "core/rendering/visibility.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace handmap {

namespace {

constexpr double kNear_m = 0.1;
constexpr double kFarthest_m = 2000.0;                            // the ground ends there
constexpr std::size_t kMostVertices = Surface::kMostCorners + 1;  // the near plane cuts one off

/// A surface as the camera sees it: convex, in samples.
struct Patch {
  std::int32_t surface;
  std::size_t count = 0;
  std::array<double, kMostVertices> x;
  std::array<double, kMostVertices> y;
  double top;
  double bottom;
  double at_x;  // inverse depth over the samples
  double at_y;
  double base;
};

struct Clipped {
  std::size_t count = 0;
  std::array<Vec3, kMostVertices> points;  // right, down, forward
};

Clipped clipped(const Surface& surface, const ViewCamera& camera) {
  std::array<Vec3, Surface::kMostCorners> own;
  for (std::size_t i = 0; i < surface.count; ++i) {
    const Vec3 from_eye = surface.corners[i] - camera.eye;
    own[i] = {camera.right.dot(from_eye), camera.down.dot(from_eye), camera.forward.dot(from_eye)};
  }
  Clipped result;
  for (std::size_t i = 0; i < surface.count; ++i) {
    const Vec3& a = own[i];
    const Vec3& b = own[(i + 1) % surface.count];
    if (a.z() >= kNear_m) result.points[result.count++] = a;
    if ((a.z() >= kNear_m) != (b.z() >= kNear_m)) {
      result.points[result.count++] = a + (kNear_m - a.z()) / (b.z() - a.z()) * (b - a);
    }
  }
  return result;
}

/// False where nothing of it can be in the picture.
bool project(const Surface& surface, const ViewCamera& camera, int scale, Patch& patch) {
  const Clipped points = clipped(surface, camera);
  if (points.count < 3) return false;
  patch.count = points.count;
  for (std::size_t i = 0; i < points.count; ++i) {
    const Vec3& p = points.points[i];
    patch.x[i] = (camera.cx + camera.fx * p.x() / p.z() + 0.5) * scale - 0.5;
    patch.y[i] = (camera.cy + camera.fy * p.y() / p.z() + 0.5) * scale - 0.5;
  }
  const auto [left, right] = std::minmax_element(patch.x.begin(), patch.x.begin() + patch.count);
  const auto [top, bottom] = std::minmax_element(patch.y.begin(), patch.y.begin() + patch.count);
  if (*right < 0.0 || *left > camera.width * scale || *bottom < 0.0 ||
      *top > camera.height * scale) {
    return false;
  }
  const double towards = surface.normal.dot(surface.corners[0] - camera.eye);
  if (std::abs(towards) < 1e-9) return false;  // edge on
  patch.top = *top;
  patch.bottom = *bottom;
  const InverseDepth depth(surface.corners[0], surface.normal, camera);
  patch.at_x = depth.at_u / scale;
  patch.at_y = depth.at_v / scale;
  patch.base = depth.at(0.5 / scale - 0.5, 0.5 / scale - 0.5);
  return true;
}

class Canvas {
 public:
  Canvas(const ViewCamera& camera, int scale) : ground_(Vec3::Zero(), Vec3::UnitZ(), camera) {
    buffer_.scale = scale;
    buffer_.columns = camera.width * scale;
    buffer_.rows = camera.height * scale;
    const std::size_t samples = buffer_.index(0, buffer_.rows);
    buffer_.seen.resize(samples);
    buffer_.inverse_depth.resize(samples);
  }

  void drawRows(const std::vector<Patch>& patches, int first, int last) {
    for (int row = first; row < last; ++row) drawGround(row);
    for (const Patch& patch : patches) {
      const int top = std::max(first, static_cast<int>(std::ceil(std::max(patch.top, -1.0))));
      const int bottom = static_cast<int>(std::min(patch.bottom, last - 1.0));
      for (int row = top; row <= bottom; ++row) drawRow(patch, row);
    }
  }

  Visibility take() { return std::move(buffer_); }
  int rows() const { return buffer_.rows; }

 private:
  void drawGround(int row) {
    const std::size_t begin = buffer_.index(0, row);
    const double v = buffer_.pixelOf(row);
    for (int column = 0; column < buffer_.columns; ++column) {
      const double depth = ground_.at(buffer_.pixelOf(column), v);
      const bool ground = depth > 1.0 / kFarthest_m;
      const std::size_t i = begin + static_cast<std::size_t>(column);
      buffer_.seen[i] = ground ? Visibility::kGround : Visibility::kSky;
      buffer_.inverse_depth[i] = ground ? static_cast<float>(depth) : 0.0F;
    }
  }

  void drawRow(const Patch& patch, int row) {
    const double y = row;
    double left = 1e300;
    double right = -1e300;
    for (std::size_t i = 0, j = patch.count - 1; i < patch.count; j = i++) {
      if ((patch.y[i] < y) == (patch.y[j] < y)) continue;
      const double x =
          patch.x[i] + (y - patch.y[i]) / (patch.y[j] - patch.y[i]) * (patch.x[j] - patch.x[i]);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int begin = static_cast<int>(std::ceil(std::clamp(left, 0.0, 1.0 * buffer_.columns)));
    const int end = static_cast<int>(std::ceil(std::clamp(right, 0.0, 1.0 * buffer_.columns)));
    const double base = patch.base + patch.at_y * y;
    float* const depths = buffer_.inverse_depth.data() + buffer_.index(0, row);
    std::int32_t* const seen = buffer_.seen.data() + buffer_.index(0, row);
    for (int column = begin; column < end; ++column) {
      const auto depth = static_cast<float>(base + patch.at_x * column);
      if (depth <= depths[column]) continue;
      depths[column] = depth;
      seen[column] = patch.surface;
    }
  }

  InverseDepth ground_;
  Visibility buffer_;
};

}  // namespace

InverseDepth::InverseDepth(const Vec3& point, const Vec3& normal, const ViewCamera& camera) {
  const double distance = normal.dot(point - camera.eye);
  at_u = normal.dot(camera.right) / camera.fx / distance;
  at_v = normal.dot(camera.down) / camera.fy / distance;
  base = normal.dot(camera.forward) / distance - at_u * camera.cx - at_v * camera.cy;
}

Visibility visibilityOf(const std::vector<Surface>& surfaces, const ViewCamera& camera, int scale) {
  std::vector<Patch> patches;
  patches.reserve(surfaces.size());
  Patch patch;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    patch.surface = static_cast<std::int32_t>(i);
    if (project(surfaces[i], camera, scale, patch)) patches.push_back(patch);
  }
  Canvas canvas(camera, scale);
  constexpr int kBand = 32;
  parallelStretches(canvas.rows(), kBand,
                    [&](int begin, int end) { canvas.drawRows(patches, begin, end); });
  return canvas.take();
}

}  // namespace handmap
