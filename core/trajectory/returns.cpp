#include "core/trajectory/returns.h"

#include <algorithm>
#include <cmath>

#include "core/perception/range_walls.h"
#include "core/trajectory/constants.h"
#include "core/trajectory/scan_noise.h"

namespace handmap {

using namespace trajectory;

Returns usableReturns(const std::vector<RangePoint>& points, double range_limit_m) {
  Returns returns;
  std::copy_if(
      points.begin(), points.end(), std::back_inserter(returns.all), [&](const RangePoint& p) {
        const double range = std::hypot(p.x, p.y);
        return range >= kOwnBody_m && range <= range_limit_m && std::isfinite(p.z) && p.w > 0.0F;
      });
  returns.planar = isPlanar(returns.all);
  for (const RangePoint& p : returns.all) {
    if (returns.planar || (p.z > perception::kTall_m && p.z < perception::kHighest_m))
      returns.upright.emplace_back(p.x, p.y);
  }
  return returns;
}

std::vector<TrackedPoint> trackedPoints(const std::vector<RangePoint>& points,
                                        const std::vector<std::uint32_t>& ids) {
  std::vector<TrackedPoint> tracked;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const RangePoint& p = points[i];
    const Vec2 at(p.x, p.y);
    const bool usable = std::isfinite(p.z) && at.allFinite() && at.norm() >= kOwnBody_m;
    if (ids[i] != 0 && usable) tracked.push_back({ids[i], at, p.z});
  }
  return tracked;
}

std::vector<ScanPoint> features(const Returns& returns, const ScanNoise& noise) {
  return returns.planar ? planarFeatures(returns.all, noise)
                        : standingFeatures(returns.upright, noise);
}

SharpnessFrame sharpnessFrame(const Returns& returns, double range_limit_m,
                              const ScanNoise& noise) {
  const double most = std::min(kSharpRange_m, kSharpShare * range_limit_m);
  std::vector<SharpnessPoint> near;
  for (const Vec2& at : returns.upright) {
    if (at.norm() < most) near.push_back({at, noise.sigma(at.norm())});
  }
  std::vector<SharpnessPoint> frame;
  const std::size_t stride = near.size() / kSharpPoints + 1;
  frame.reserve(near.size() / stride + 1);  // kept for the whole run
  for (std::size_t i = 0; i < near.size(); i += stride) frame.push_back(near[i]);
  return std::make_shared<const std::vector<SharpnessPoint>>(std::move(frame));
}

}  // namespace handmap
