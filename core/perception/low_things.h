// Things that a range sensor looks over: fences, hedges, garages.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/perception/constants.h"

namespace handmap {

/// A spinning lidar hardly looks upwards: near by it cannot tell a fence from a house. From farther
/// away its rays pass over the fence, and what they passed over is remembered by place and height.
class LowThings {
 public:
  /// Heights between `low_m` and `high_m` above ground are told apart; `range_m`: of the sensor.
  LowThings(double low_m, double high_m, double range_m);

  double low() const { return low_; }
  double high() const { return high_; }
  /// A ray ended, or passed, at `height_m` above ground. Odometry frame; heights below `low` say
  /// nothing, those above `high` that something ends here that is not low.
  void addStop(const Vec2& at, double height_m);
  void addPass(const Vec2& at, double height_m);
  /// Whether rays passed over what stands there, below `high`.
  bool isLow(const Vec2& at) const;

 private:
  struct Place {
    std::int64_t column = 0;
    std::int64_t row = 0;
    bool operator==(const Place&) const = default;
  };
  struct Cell {
    Place place;
    std::array<std::uint16_t, perception::kLowBins + 1> stops{};
    std::array<std::uint16_t, perception::kLowBins + 1> passes{};
  };

  static Place placeOf(const Vec2& at);
  std::size_t indexOf(const Place& place) const;
  Cell& ownCell(const Vec2& at);
  std::size_t binOf(double height_m) const;

  double low_;
  double high_;
  std::int64_t side_;        ///< cells, a power of two
  std::vector<Cell> cells_;  ///< of a square that moves with the robot, wrapped around
};

}  // namespace handmap
