#include "core/trajectory/submap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "core/geometry/to_outer.h"
#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

namespace {

int cellOf(double v) { return static_cast<int>(std::floor(v / kCell_m)) + kSide / 2; }

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

/// Some cells, seen from `expected` turned so many steps. The cells there lie `dx`, `dy` farther.
struct Placement {
  int turn;
  int dx;
  int dy;
  int hits;
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

/// How many of the cells, moved so far, or by up to `block` − 1 cells more, are ones of `kinds`.
int hitsOf(const std::vector<std::uint32_t>& kinds, const std::vector<CellOf>& cells, int dx,
           int dy, int block) {
  int hits = 0;
  for (const CellOf& cell : cells) {
    const int x = cell.x + dx;
    const int y = cell.y + dy;
    if (x <= -block || y <= -block || x >= kSide || y >= kSide) continue;
    const auto at = static_cast<std::size_t>(std::max(y, 0) * kSide + std::max(x, 0));
    hits += (kinds[at] & cell.kind) != 0;
  }
  return hits;
}

/// The one with most hits, the first of several; nullopt where one elsewhere has nearly as many.
std::optional<Placement> clearBest(const std::vector<Placement>& placements) {
  const auto best = std::ranges::max_element(
      placements, {}, [](const Placement& p) { return std::tuple(p.hits, -p.turn, -p.dy, -p.dx); });
  if (best == placements.end() || best->hits == 0) return std::nullopt;
  const bool doubtful = std::ranges::any_of(placements, [&](const Placement& p) {
    const bool other = std::hypot(p.dx - best->dx, p.dy - best->dy) * kCell_m > kShift_m ||
                       std::abs(p.turn - best->turn) * kTurnStep > kOtherTurn;
    return other && p.hits > kMostOther * best->hits;
  });
  return doubtful ? std::nullopt : std::optional(*best);
}

/// Cells of a side of what is looked at together: no other place is as near.
int blockSide() { return static_cast<int>(kShift_m / kCell_m); }

}  // namespace

WallGrid::WallGrid(const std::vector<ScanPoint>& points)
    : kinds_(static_cast<std::size_t>(kSide) * static_cast<std::size_t>(kSide)) {
  for (const ScanPoint& p : points) {
    if (!p.known()) continue;
    for (const double dx : {-kNear_m, kNear_m}) {
      for (const double dy : {-kNear_m, kNear_m}) mark(p.at + Vec2(dx, dy), kindsOf(p));
    }
  }
  blocks_ = kinds_;
  const auto side = static_cast<std::size_t>(blockSide());
  for (const std::size_t step : {std::size_t{1}, static_cast<std::size_t>(kSide)}) {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      for (std::size_t k = 1; k < side && i + k * step < blocks_.size(); ++k)
        blocks_[i] |= blocks_[i + k * step];
    }
  }
}

void WallGrid::mark(const Vec2& at, std::uint32_t kinds) {
  const int x = cellOf(at.x());
  const int y = cellOf(at.y());
  if (x < 0 || y < 0 || x >= kSide || y >= kSide) return;
  kinds_[static_cast<std::size_t>(y * kSide + x)] |= kinds;
}

/// Branch and bound (Olson 2009): what a block of places has at most tells which are worth a look.
std::optional<Pose2> WallGrid::find(const std::vector<ScanPoint>& points, const Pose2& expected,
                                    const SearchWindow& window) const {
  std::vector<ScanPoint> known;
  std::copy_if(points.begin(), points.end(), std::back_inserter(known),
               [](const ScanPoint& p) { return p.known(); });
  const int shifts = static_cast<int>(std::ceil(window.shift_m / kCell_m));
  const int turns = static_cast<int>(std::ceil(window.turn / kTurnStep));
  const int side = blockSide();
  const auto pose = [&](int turn, int dx, int dy) {
    return Pose2{expected.x + dx * kCell_m, expected.y + dy * kCell_m,
                 normalizedAngle(expected.heading + turn * kTurnStep)};
  };
  std::vector<std::vector<CellOf>> cells;  // by turn
  std::vector<Placement> blocks;
  for (int turn = -turns; turn <= turns; ++turn) {
    cells.push_back(placed(known, pose(turn, 0, 0)));
    for (int dy = -shifts; dy <= shifts; dy += side) {
      for (int dx = -shifts; dx <= shifts; dx += side)
        blocks.push_back({turn, dx, dy, hitsOf(blocks_, cells.back(), dx, dy, side)});
    }
  }
  std::ranges::sort(blocks, std::greater(), &Placement::hits);
  std::vector<Placement> placements;
  int most = 0;
  for (const Placement& block : blocks) {
    if (block.hits <= kMostOther * most) break;
    const std::vector<CellOf>& seen = cells[static_cast<std::size_t>(block.turn + turns)];
    for (int dy = block.dy; dy < block.dy + side && dy <= shifts; ++dy) {
      for (int dx = block.dx; dx < block.dx + side && dx <= shifts; ++dx) {
        placements.push_back({block.turn, dx, dy, hitsOf(kinds_, seen, dx, dy, 1)});
        most = std::max(most, placements.back().hits);
      }
    }
  }
  const auto best = clearBest(placements);
  if (!best || std::abs(best->dx) == shifts || std::abs(best->dy) == shifts ||
      std::abs(best->turn) == turns)
    return std::nullopt;
  return pose(best->turn, best->dx, best->dy);
}

}  // namespace handmap
