#include "core/trajectory/loop_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/perception/constants.h"
#include "core/trajectory/constants.h"
#include "core/trajectory/scan_match.h"

namespace handmap {

using namespace trajectory;

void LoopSearch::add(const Pose2& smooth, const std::vector<ScanPoint>& scan) {
  Keyframe keyframe{smooth, 0.0, {}};
  if (!keyframes_.empty()) {
    const Keyframe& before = keyframes_.back();
    keyframe.travelled_m =
        before.travelled_m + (smooth.position() - before.smooth.position()).norm();
  }
  const auto near = [](const ScanPoint& p) { return p.at.norm() < perception::kFar_m; };
  keyframe.scan.reserve(  // for the whole run, and not an entry more
      static_cast<std::size_t>(std::count_if(scan.begin(), scan.end(), near)));
  std::copy_if(scan.begin(), scan.end(), std::back_inserter(keyframe.scan), near);
  points_ += keyframe.scan.size();
  keyframes_.push_back(std::move(keyframe));
  if (points_ > most_points_) thinOut();
}

void LoopSearch::thinOut() {
  const std::size_t whole = 2 * kSourceReach + 2;  // what is still to be searched with
  spacing_ *= 2;
  for (std::size_t i = 0; i + whole < keyframes_.size(); ++i) {
    if (i % spacing_ == 0 || keyframes_[i].scan.empty()) continue;
    points_ -= keyframes_[i].scan.size();
    keyframes_[i].scan = {};
  }
}

std::vector<ScanPoint> LoopSearch::submap(std::size_t middle, std::size_t reach) const {
  std::vector<ScanPoint> points;
  const std::size_t first = middle - std::min(middle, reach);
  const std::size_t last = std::min(middle + reach, keyframes_.size() - 1);
  for (std::size_t i = first; i <= last; ++i) {
    const Pose2 pose = between(keyframes_[middle].smooth, keyframes_[i].smooth);
    const std::vector<ScanPoint> seen = moved(keyframes_[i].scan, pose);
    points.insert(points.end(), seen.begin(), seen.end());
  }
  return thinned(points, kNear_m);
}

/// Of each visit, a run of keyframes within reach, the nearest.
std::vector<std::size_t> LoopSearch::candidates(std::size_t newest, const std::vector<Pose2>& poses,
                                                double reach_m) const {
  std::vector<std::size_t> nearest;
  bool within = false;
  const auto distance = [&](std::size_t i) {
    return (poses[i].position() - poses[newest].position()).norm();
  };
  for (std::size_t i = 0; i < newest; ++i) {
    if (keyframes_[newest].travelled_m - keyframes_[i].travelled_m < kApart_m) break;
    const bool near = distance(i) < reach_m;
    if (near && !within) nearest.push_back(i);
    if (near && distance(i) < distance(nearest.back())) nearest.back() = i;
    within = near;
  }
  return nearest;
}

std::vector<Loop> LoopSearch::search(const std::vector<Pose2>& poses, const std::stop_token& stop) {
  if (keyframes_.size() <= kSourceReach) return {};
  const std::size_t newest = keyframes_.size() - 1 - kSourceReach;
  const double since = keyframes_[newest].travelled_m - closed_m_;
  const SearchWindow window{std::min(kShift_m + kMatchedScans.along_per_m * since, kMostShift_m),
                            std::min(kTurn + kTurnPerMetre * since, kMostTurn)};
  const std::vector<std::size_t> places = candidates(newest, poses, kPassing_m + window.shift_m);
  if (places.empty()) return {};
  const std::vector<ScanPoint> seen = submap(newest, kSourceReach);
  std::vector<Loop> loops;
  for (const std::size_t place : places) {
    if (stop.stop_requested()) break;
    const Pose2 expected = between(poses[place], poses[newest]);
    if (const auto loop = close(place, newest, seen, expected, window)) loops.push_back(*loop);
  }
  if (!loops.empty()) closed_m_ = keyframes_[newest].travelled_m;
  return loops;
}

std::optional<Loop> LoopSearch::close(std::size_t from, std::size_t to,
                                      const std::vector<ScanPoint>& seen, const Pose2& expected,
                                      const SearchWindow& window) const {
  const std::vector<ScanPoint> target = submap(from, 2 * kSourceReach);  // covers it
  const auto coarse = WallGrid(target).find(seen, expected, window);
  if (!coarse) return std::nullopt;
  PointMap map;
  map.add(target, 0);
  const auto match = matchScan(seen, map, *coarse, kLoopGates_m);
  if (!match || !(weakerShare(*match) > kLeastEigenRatio)) return std::nullopt;
  const bool followed = std::ranges::any_of(seen, &ScanPoint::followed);
  if (match->near < (followed ? kLeastMatched : kLeastNear) ||
      match->near < (followed ? kLeastFollowed : kLeastShare) * match->known)
    return std::nullopt;
  const auto root = rootInformation(*match, {perception::kWall_m, perception::kWall_m, kFloorTurn});
  if (!root) return std::nullopt;
  return Loop{from, to, {match->pose, *root}};
}

}  // namespace handmap
