#include "core/perception/joined_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/geometry/to_outer.h"
#include "core/perception/constants.h"
#include "core/perception/range_walls.h"

namespace handmap {

using namespace perception;

namespace {

bool areSame(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a - b).squaredNorm() <= kSame_m * kSame_m;
}

using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

Cell cellOf(const Eigen::Vector3d& p) {
  return (p / (2.0 * kSame_m)).array().floor().cast<std::int64_t>();
}
std::int64_t keyOf(const Cell& cell) {
  return (cell.x() * 73'856'093) ^ (cell.y() * 19'349'663) ^ (cell.z() * 83'492'791);
}

std::vector<Eigen::Vector3d> placed(const std::vector<RangePoint>& points, const Pose2& odometry) {
  std::vector<Eigen::Vector3d> places;
  places.reserve(points.size());
  const ToOuter outer(odometry);
  for (const RangePoint& p : points) {
    const Vec2 at = outer(Vec2(static_cast<double>(p.x), static_cast<double>(p.y)));
    places.emplace_back(at.x(), at.y(), static_cast<double>(p.z));
  }
  return places;
}

/// A followed point is looked at once a frame.
bool hasTwice(std::vector<std::uint32_t> ids) {
  std::erase(ids, 0U);
  std::sort(ids.begin(), ids.end());
  return std::adjacent_find(ids.begin(), ids.end()) != ids.end();
}

}  // namespace

bool JoinedFrames::repeat(const std::vector<Eigen::Vector3d>& placed) const {
  const std::size_t stride = std::max<std::size_t>(1, placed.size() / kSample);
  std::size_t asked = 0;
  std::size_t had = 0;
  for (std::size_t i = 0; i < placed.size(); i += stride) {
    ++asked;
    if (std::ranges::any_of(before_, [&](const auto& b) { return areSame(placed[i], b); })) ++had;
  }
  return 2 * had > asked;
}

bool JoinedFrames::wasThere(const Eigen::Vector3d& p) const {
  if (!p.allFinite()) return false;
  // What is the same lies in the cell or in one of those at its nearest corner.
  const Cell first = cellOf(p.array() - kSame_m);
  for (int i = 0; i < 8; ++i) {
    if (seen_.contains(keyOf(first + Cell(i & 1, (i >> 1) & 1, i >> 2)))) return true;
  }
  return false;
}

void JoinedFrames::removeRepeats(SeenPoints& seen, const Pose2& odometry) {
  auto& [points, ids] = seen;
  std::vector<Eigen::Vector3d> places = placed(points, odometry);
  const double moved_m = between(last_, odometry).position().norm();
  driven_m_ += moved_m;
  if (!before_.empty() && moved_m > kMoved_m) joined_ = repeat(places);
  if (joined_ && givesOneReturnADirection(points)) joined_ = false;  // one look, not many
  joined_ = joined_ || hasTwice(ids);
  if (joined_) {
    for (const Eigen::Vector3d& p : before_) {
      if (p.allFinite()) seen_[keyOf(cellOf(p))] = driven_m_;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (wasThere(places[i])) continue;
      if (!ids.empty()) ids[kept] = ids[i];
      points[kept++] = points[i];
    }
    points.resize(kept);
    if (!ids.empty()) ids.resize(kept);
    if (seen_.size() > kMostPlaces) {
      std::erase_if(seen_,
                    [&](const auto& place) { return driven_m_ - place.second > kJoinedWay_m; });
    }
  }
  last_ = odometry;
  before_ = std::move(places);
}

}  // namespace handmap
