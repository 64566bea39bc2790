// The two long faces of houses wall to wall, as their returns show them.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/outlines/structure.h"

namespace handmap {

/// Where a row may stand: along its heading and across it (to the left), metres.
struct RowBand {
  double heading = 0.0;  ///< radians
  double from, to;
  double low, high;
};

class RowFaces {
 public:
  enum Face { kLow, kHigh };  ///< seen from where across is less, or more

  RowFaces(const PlacedRays& placed, const RowBand& band);

  /// How the faces are turned against the heading, radians.
  double turn() const { return turn_; }
  /// As far as the walls of from..to go on, but for gaps of less than kWallToWall_m.
  std::pair<double, double> seenAround(double from, double to) const;
  /// How well the returns of a stretch fit to one plane face each, which is not far from that of
  /// the whole row; nats, at most 0.
  double evidence(double from, double to) const;
  /// Where a stretch has that face; none where nothing of it was seen.
  std::optional<double> across(Face face, double from, double to) const;

 private:
  struct Best {
    double nats = 0.0;
    int depth = 0;
  };
  int cellOf(double along) const;
  std::optional<std::size_t> crossed(const PlacedRay& ray, const Vec2& along, const Vec2& across,
                                     double middle) const;
  Best best(Face face, int from, int to) const;
  double& sum(Face face, int depth, int cell);
  double sum(Face face, int depth, int cell) const;

  RowBand band_;
  double turn_ = 0.0;
  int cells_, depths_;
  std::array<std::vector<double>, 2> sums_;  ///< up to each cell, by depth
  std::vector<int> returns_;                 ///< of whatever, less rays that go through, by cell
  std::array<std::vector<int>, 2> seen_;     ///< cells that were seen, up to each
  std::array<std::optional<int>, 2> whole_;  ///< depth of the whole row
};

}  // namespace handmap
