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

/// The bits beyond those of the ways, by how high a followed point is: the lowest is what is 0.5 m
/// below the ground and lower.
unsigned bitOf(float height) {
  return 6U + static_cast<unsigned>(std::clamp(std::floor(height / kCell_m), -1.0, 24.0));
}

std::uint32_t kindsOf(const ScanPoint& point) {
  if (point.followed()) return 0b111U << (bitOf(point.height) - 1);
  const Vec2& normal = point.normal;
  unsigned bits = 0;
  if (normal.x() > kFaceReach) bits |= 1U;
  if (normal.y() > kFaceReach) bits |= 2U;
  if (-normal.x() > kFaceReach) bits |= 4U;
  if (-normal.y() > kFaceReach) bits |= 8U;
  return bits;
}

struct CellOf {
  int x;
  int y;
  std::uint32_t kind;
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
    const std::uint32_t kind = points[i].followed()
                                   ? 1U << bitOf(points[i].height)
                                   : 1U << nearestFace(outer.turned(points[i].normal));
    cells.push_back({cellOf(at.x()), cellOf(at.y()), kind});
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
    : kinds_(static_cast<std::size_t>(kSide) * static_cast<std::size_t>(kSide)) {
  for (const ScanPoint& p : points) {
    if (!p.known()) continue;
    for (const double dx : {-kNear_m, kNear_m}) {
      for (const double dy : {-kNear_m, kNear_m}) mark(p.at + Vec2(dx, dy), kindsOf(p));
    }
  }
}

void WallGrid::mark(const Vec2& at, std::uint32_t kinds) {
  const int x = cellOf(at.x());
  const int y = cellOf(at.y());
  if (x < 0 || y < 0 || x >= kSide || y >= kSide) return;
  kinds_[static_cast<std::size_t>(y * kSide + x)] |= kinds;
}

std::optional<Pose2> WallGrid::find(const std::vector<ScanPoint>& points, const Pose2& expected,
                                    const SearchWindow& window) const {
  std::vector<ScanPoint> known;
  std::copy_if(points.begin(), points.end(), std::back_inserter(known),
               [](const ScanPoint& p) { return p.known(); });
  const int shifts = static_cast<int>(std::ceil(window.shift_m / kCell_m));
  const int turns = static_cast<int>(std::ceil(window.turn / kTurnStep));
  std::vector<Placement> placements;
  for (int turn = -turns; turn <= turns; ++turn) {
    Pose2 pose = expected;
    pose.heading = normalizedAngle(expected.heading + turn * kTurnStep);
    const std::vector<CellOf> cells = placed(known, pose);
    for (int dy = -shifts; dy <= shifts; ++dy) {
      for (int dx = -shifts; dx <= shifts; ++dx) {
        int hits = 0;
        for (const CellOf& cell : cells) {
          const int x = cell.x + dx;
          const int y = cell.y + dy;
          if (x < 0 || y < 0 || x >= kSide || y >= kSide) continue;
          hits += (kinds_[static_cast<std::size_t>(y * kSide + x)] & cell.kind) != 0;
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
