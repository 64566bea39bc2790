// What was seen along a few metres of way, in the frame of its middle, and where one such piece
// lies in another.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/trajectory/point_map.h"

namespace handmap {

/// How far from the expected place is searched.
struct SearchWindow {
  double shift_m;
  double turn;  ///< radians
};

/// Where straight pieces and followed points are, in cells of 0.5 m and by which of four ways they
/// face, or how high they are.
class WallGrid {
 public:
  explicit WallGrid(const std::vector<ScanPoint>& points);

  /// The pose, in the grid's frame, at which most of those of `points` lie on ones of the grid;
  /// nullopt where another place does nearly as well, or the window's edge does best.
  std::optional<Pose2> find(const std::vector<ScanPoint>& points, const Pose2& expected,
                            const SearchWindow& window) const;

 private:
  void mark(const Vec2& at, std::uint32_t kinds);

  std::vector<std::uint32_t> kinds_;   ///< a bit for each way and each height
  std::vector<std::uint32_t> blocks_;  ///< the same of a square of cells from each on
};

}  // namespace handmap
