#include "core/explain/witness_windows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "core/classification/windows.h"
#include "core/explain/constants.h"

namespace handmap {

using namespace explain;

namespace {

struct Pillar {
  int column;  ///< of windows
  int ground;  ///< row of windows
  int top;     ///< the same of a point three metres up
};

/// The centre of the first pixel is 0.
int windowOf(double pixel) { return static_cast<int>(std::floor((pixel + 0.5) / kWindow_px)); }

/// A return and what stands above it.
std::optional<Pillar> pillarOf(const Vec2& in_robot, const StereoCamera& camera, double pan) {
  const CameraMount& mount = camera.mount;
  const Pose2 level{mount.x, mount.y, mount.yaw + pan};
  const Vec2 ahead = level.toOwn(in_robot);
  const double c = std::cos(mount.pitch);
  const double s = std::sin(mount.pitch);
  const auto depth = [&](double up) { return c * ahead.x() - s * up; };
  const auto row = [&](double up) {
    return camera.cy + camera.fy * (-s * ahead.x() - c * up) / depth(up);
  };
  const double below = -mount.z;
  if (depth(below) < kNearest_m || depth(below + kUp_m) < kNearest_m) return std::nullopt;
  return Pillar{windowOf(camera.cx - camera.fx * ahead.y() / depth(0.0)), windowOf(row(below)),
                windowOf(row(below + kUp_m))};
}

}  // namespace

std::vector<cv::Rect> windowsOf(const WallWitness& witness, const StereoCamera& camera, double pan,
                                const cv::Mat1f& buildings, cv::Size size) {
  std::set<std::pair<int, int>> windows;  // row, column
  const int columns = size.width / kWindow_px;
  const int rows = size.height / kWindow_px;
  const bool judged = buildings.cols == columns && buildings.rows == rows;
  for (const Vec2& end : witness.returns) {
    const auto pillar = pillarOf(witness.pose.toOwn(end), camera, pan);
    if (!pillar || pillar->column < 0 || pillar->column >= columns) continue;
    const int ground = std::min(pillar->ground, rows - 1);
    const int top = judged ? 0 : std::max(0, pillar->top);
    for (int row = ground; row >= top; --row) {
      if (judged && buildings(row, pillar->column) <= kBuilding) continue;
      windows.insert({row, pillar->column});
    }
  }
  std::vector<cv::Rect> rectangles;
  for (const auto& [row, column] : windows) {
    rectangles.emplace_back(column * kWindow_px, row * kWindow_px, kWindow_px, kWindow_px);
  }
  return rectangles;
}

}  // namespace handmap
