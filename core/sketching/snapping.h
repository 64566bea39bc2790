// Where a point that a person places is drawn to: corners and walls of what is drawn, the lines
// that walls lie on, right angles to the edge before, and a grid.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/polygon.h"

namespace handmap {

enum class SnapKind { None, Grid, Line, RightAngle, Wall, Crossing, Corner };  ///< rising strength

struct SnapModes {
  bool grid = false;
  bool objects = true;  ///< corners, walls, their lines and right angles
  bool operator==(const SnapModes&) const = default;
};

/// What there is to snap to; metres.
struct SnapCandidates {
  std::vector<Segment> walls = {};  ///< around the pointer; their ends are corners
  std::vector<Vec2> from = {};      ///< the points that the placed one is joined to
  std::optional<Vec2> along = {};   ///< the way of the edge before, any length
};

struct Snap {
  Vec2 point = Vec2::Zero();
  SnapKind kind = SnapKind::None;
  std::vector<Segment> guides = {};  ///< what the point lies on, as far as the point
};

class Snapper {
 public:
  static constexpr double kTidy = 0.01;  ///< what is drawn to nothing lies on whole centimetres

  /// `reach`: how far a point is drawn; `grid_step`: of the grid; both metres and positive.
  Snapper(SnapModes modes, double reach, double grid_step)
      : modes_(modes), reach_(reach), grid_step_(grid_step) {}

  /// The strongest thing within reach; a crossing of two lines before either.
  Snap snap(const Vec2& pointer, const SnapCandidates& candidates) const;
  /// For a shape on its way: the offset near `offset` at which one of its `corners` fits best.
  /// `point` is the offset; the kind is None where no corner fits.
  Snap snapOffset(const std::vector<Vec2>& corners, const Vec2& offset,
                  const SnapCandidates& candidates) const;

 private:
  struct Line;

  std::optional<Snap> corner(const Vec2& pointer, const SnapCandidates& candidates) const;
  std::vector<Line> lines(const Vec2& pointer, const SnapCandidates& candidates) const;
  std::optional<Snap> crossing(const Vec2& pointer, const std::vector<Line>& lines) const;
  Vec2 onLine(const Line& line, const Vec2& pointer) const;
  double step() const { return modes_.grid ? grid_step_ : kTidy; }

  SnapModes modes_;
  double reach_;
  double grid_step_;
};

/// The point on the nearest multiples of `step`, as short decimals.
Vec2 roundedTo(const Vec2& point, double step);

}  // namespace handmap
