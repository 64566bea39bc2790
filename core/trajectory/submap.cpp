#include "core/trajectory/submap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/to_outer.h"
#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

namespace {

int cellOf(double v) { return static_cast<int>(std::floor(v / kCell_m) + kSide / 2); }

int nearestFace(const Vec2& normal) {
  if (std::abs(normal.x()) >= std::abs(normal.y())) return normal.x() > 0.0 ? 0 : 2;
  return normal.y() > 0.0 ? 1 : 3;
}

std::uint8_t faces(const Vec2& normal) {
  unsigned bits = 0;
  if (normal.x() > kFaceReach) bits |= 1U;
  if (normal.y() > kFaceReach) bits |= 2U;
  if (-normal.x() > kFaceReach) bits |= 4U;
  if (-normal.y() > kFaceReach) bits |= 8U;
  return static_cast<std::uint8_t>(bits);
}

struct CellOf {
  int x;
  int y;
  std::uint8_t face;
};

struct Placement {
  Pose2 pose;
  int hits = 0;
  bool at_edge = false;
};

/// Every point a cell and a way, seen from `pose`.
std::vector<CellOf> placed(const std::vector<ScanPoint>& points, const Pose2& pose) {
  std::vector<CellOf> cells;
  const std::size_t stride = points.size() / kMostSubmapPoints + 1;
  const ToOuter outer(pose);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const Vec2 at = outer(points[i].at);
    const auto face = static_cast<std::uint8_t>(1U << nearestFace(outer.turned(points[i].normal)));
    cells.push_back({cellOf(at.x()), cellOf(at.y()), face});
  }
  return cells;
}

std::optional<Pose2> clearBest(const std::vector<Placement>& placements) {
  const auto best =
      std::max_element(placements.begin(), placements.end(),
                       [](const Placement& a, const Placement& b) { return a.hits < b.hits; });
  if (best == placements.end() || best->hits == 0 || best->at_edge) return std::nullopt;
  const bool doubtful = std::any_of(placements.begin(), placements.end(), [&](const Placement& p) {
    const Pose2 off = between(best->pose, p.pose);
    const bool other = off.position().norm() > kShift_m || std::abs(off.heading) > kOtherTurn;
    return other && p.hits > kMostOther * best->hits;
  });
  return doubtful ? std::nullopt : std::optional(best->pose);
}

}  // namespace

WallGrid::WallGrid(const std::vector<ScanPoint>& points)
    : faces_(static_cast<std::size_t>(kSide) * static_cast<std::size_t>(kSide)) {
  for (const ScanPoint& p : points) {
    if (!p.straight()) continue;
    for (const double dx : {-kNear_m, kNear_m}) {
      for (const double dy : {-kNear_m, kNear_m}) mark(p.at + Vec2(dx, dy), faces(p.normal));
    }
  }
}

void WallGrid::mark(const Vec2& at, std::uint8_t faces) {
  const int x = cellOf(at.x());
  const int y = cellOf(at.y());
  if (x < 0 || y < 0 || x >= kSide || y >= kSide) return;
  faces_[static_cast<std::size_t>(y * kSide + x)] |= faces;
}

std::optional<Pose2> WallGrid::find(const std::vector<ScanPoint>& points, const Pose2& expected,
                                    const SearchWindow& window) const {
  std::vector<ScanPoint> straight;
  std::copy_if(points.begin(), points.end(), std::back_inserter(straight),
               [](const ScanPoint& p) { return p.straight(); });
  const int shifts = static_cast<int>(std::ceil(window.shift_m / kCell_m));
  const int turns = static_cast<int>(std::ceil(window.turn / kTurnStep));
  std::vector<Placement> placements;
  for (int turn = -turns; turn <= turns; ++turn) {
    Pose2 pose = expected;
    pose.heading = normalizedAngle(expected.heading + turn * kTurnStep);
    const std::vector<CellOf> cells = placed(straight, pose);
    for (int dy = -shifts; dy <= shifts; ++dy) {
      for (int dx = -shifts; dx <= shifts; ++dx) {
        int hits = 0;
        for (const CellOf& cell : cells) {
          const int x = cell.x + dx;
          const int y = cell.y + dy;
          if (x < 0 || y < 0 || x >= kSide || y >= kSide) continue;
          hits += (faces_[static_cast<std::size_t>(y * kSide + x)] & cell.face) != 0;
        }
        const bool edge =
            std::abs(dx) == shifts || std::abs(dy) == shifts || std::abs(turn) == turns;
        placements.push_back(
            {{pose.x + dx * kCell_m, pose.y + dy * kCell_m, pose.heading}, hits, edge});
      }
    }
  }
  return clearBest(placements);
}

}  // namespace handmap
