// Points of several scans in one frame, found by place.
#pragma once

#include <vector>

#include "core/trajectory/scan_features.h"

namespace handmap {

/// Cells of 0.5 m that repeat every 128 m: it holds what is around one place, at most 64 m away in
/// x and y from what is looked for.
class PointMap {
 public:
  PointMap();

  /// `scan` numbers the scans, never downwards. A cell that is full of its kind takes no more.
  void add(const std::vector<ScanPoint>& points, int scan);
  /// Forgets the scans before this one.
  void dropBefore(int scan) { oldest_ = scan; }

  /// The nearest of the same kind: both followed and as high, on no straight piece, or on ones
  /// whose normals differ by less than 45°. nullptr: none within the distance.
  const ScanPoint* nearest(const ScanPoint& point, double within_m) const;

 private:
  struct Entry {
    ScanPoint point;
    int scan;
  };
  std::vector<Entry>& cellAt(const Vec2& at);

  std::vector<std::vector<Entry>> cells_;
  int oldest_ = 0;
};

}  // namespace handmap
