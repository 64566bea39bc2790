#include "core/evaluation/comparison.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "core/evaluation/rigid_motion.h"

namespace handmap {

namespace {

constexpr double kFarAhead = 1e6;  // where the line ahead of a start ends, metres

/// The same rectangle with its heading turned by quarters.
Rectangle turned(const Rectangle& box, int quarters) {
  Rectangle result = box;
  if (quarters % 2 != 0) std::swap(result.width, result.depth);
  result.heading = normalizedAngle(box.heading + quarters * kPi / 2.0);
  return result;
}

Rectangle turnedTowards(const Rectangle& box, double heading) {
  const double quarters = normalizedAngle(heading - box.heading) / (kPi / 2.0);
  return turned(box, static_cast<int>(std::lround(quarters)));
}

/// Middle of the wall that lies to the right of the heading.
Vec2 rightWall(const Rectangle& box) {
  return box.centre - box.depth / 2.0 * perpendicular(unitVector(box.heading));
}

/// Where the robot goes, or else the middle of the map.
class Viewpoint {
 public:
  explicit Viewpoint(const Map& truth) : route_(truth.route), known_(true) {
    if (truth.start) {
      const Vec2 ahead = kFarAhead * unitVector(truth.start->heading);
      if (route_.empty())
        route_ = {truth.start->position() - ahead, truth.start->position() + ahead};
      else
        route_.insert(route_.begin(), truth.start->position());
    }
    if (!route_.empty()) return;
    known_ = false;
    Vec2 middle = Vec2::Zero();
    for (const Building& building : truth.buildings) middle += building.box().centre;
    route_ = {middle / std::max(1.0, static_cast<double>(truth.buildings.size()))};
  }

  /// By how many quarters to turn the box so that the front wall lies to the right of its heading.
  int quartersToFront(const Rectangle& box) const {
    int best = 0;
    for (int quarters = 1; quarters < 4; ++quarters) {
      if (!known_ && quarters != 2) continue;
      if (distance(rightWall(turned(box, quarters))) < distance(rightWall(turned(box, best)))) {
        best = quarters;
      }
    }
    return best;
  }

 private:
  double distance(const Vec2& point) const {
    double nearest = (route_.front() - point).norm();
    for (std::size_t i = 1; i < route_.size(); ++i) {
      nearest = std::min(nearest, distanceTo(Segment{route_[i - 1], route_[i]}, point));
    }
    return nearest;
  }

  std::vector<Vec2> route_;
  bool known_;
};

BuildingError errorOf(const Building& estimate, const Building& truth, const Viewpoint& viewpoint) {
  const int quarters = viewpoint.quartersToFront(truth.box());
  const Rectangle true_box = turned(truth.box(), quarters);
  const Rectangle box = turnedTowards(estimate.box(), true_box.heading);
  const Pose2 frame{true_box.centre.x(), true_box.centre.y(), true_box.heading};
  const Vec2 off = frame.toOwn(box.centre);
  const Polygon footprint = estimate.footprint();
  const Polygon true_footprint = truth.footprint();
  BuildingError error;
  error.id = truth.id;
  error.x = quarters < 2 ? off.x() : -off.x();
  error.front = (box.depth - true_box.depth) / 2.0 - off.y();
  error.width = box.width - true_box.width;
  error.iou = intersectionOverUnion(footprint, true_footprint);
  error.overlaps = overlap(footprint, true_footprint);
  return error;
}

struct Pair {
  const Building* truth;
  const Building* estimate;
};

/// The buildings of the truth, each with its estimate or nullptr.
std::vector<Pair> pairsOf(const Map& map, const Map& truth) {
  std::unordered_map<std::string_view, const Building*> by_id;
  for (const Building& building : map.buildings) by_id.emplace(building.id, &building);
  std::vector<Pair> pairs;
  for (const Building& building : truth.buildings) {
    const auto found = by_id.find(building.id);
    pairs.push_back({&building, found == by_id.end() ? nullptr : found->second});
  }
  return pairs;
}

Pose2 alignmentOf(const std::vector<Pair>& pairs) {
  std::vector<Vec2> from;
  std::vector<Vec2> to;
  for (const auto& [truth, estimate] : pairs) {
    if (estimate == nullptr) continue;
    from.push_back(estimate->box().centre);
    to.push_back(truth->box().centre);
  }
  return bestRigidMotion(from, to);
}

Building moved(const Building& building, const Pose2& motion) {
  Rectangle box = building.box();
  box.centre = motion.toOuter(box.centre);
  box.heading = normalizedAngle(box.heading + motion.heading);
  return building.fitted(box);
}

}  // namespace

MeanErrors MapComparison::mean(const std::vector<std::string>& ids) const {
  MeanErrors sum;
  for (const BuildingError& error : buildings) {
    if (!ids.empty() && std::find(ids.begin(), ids.end(), error.id) == ids.end()) continue;
    ++sum.buildings;
    sum.x += std::abs(error.x);
    sum.front += std::abs(error.front);
    sum.width += std::abs(error.width);
    sum.iou += error.iou;
  }
  const double n = std::max(1, sum.buildings);
  return {sum.buildings, sum.x / n, sum.front / n, sum.width / n, sum.iou / n};
}

MapComparison compareMaps(const Map& map, const Map& truth, bool aligned) {
  MapComparison comparison;
  const std::vector<Pair> pairs = pairsOf(map, truth);
  if (aligned) comparison.alignment = alignmentOf(pairs);
  const Viewpoint viewpoint(truth);
  for (const auto& [building, estimate] : pairs) {
    if (estimate == nullptr) {
      comparison.missing.push_back(building->id);
      continue;
    }
    const Building own = aligned ? moved(*estimate, comparison.alignment) : *estimate;
    comparison.buildings.push_back(errorOf(own, *building, viewpoint));
  }
  for (const auto& [building, counterpart] : pairsOf(truth, map)) {
    if (counterpart == nullptr) comparison.extra.push_back(building->id);
  }
  return comparison;
}

std::optional<TrajectoryError> compareTrajectories(const std::vector<StampedPose>& estimate,
                                                   const Trajectory& truth) {
  TrajectoryError error;
  std::vector<Vec2> from;
  std::vector<Vec2> to;
  double begin_s = 0.0;
  double end_s = 0.0;
  for (const StampedPose& stamped : estimate) {
    const std::optional<Pose2> pose = truth.at(stamped.time_s);
    if (!pose) continue;
    if (from.empty()) begin_s = stamped.time_s;
    end_s = stamped.time_s;
    from.push_back(stamped.pose.position());
    to.push_back(pose->position());
    error.end_m = (from.back() - to.back()).norm();
    error.max_m = std::max(error.max_m, error.end_m);
    error.rms_m += error.end_m * error.end_m;
    error.rms_heading += std::pow(normalizedAngle(stamped.pose.heading - pose->heading), 2);
  }
  if (from.empty()) return std::nullopt;
  const Pose2 motion = bestRigidMotion(from, to);
  for (std::size_t i = 0; i < from.size(); ++i) {
    error.aligned_rms_m += (motion.toOuter(from[i]) - to[i]).squaredNorm();
  }
  error.poses = static_cast<int>(from.size());
  for (double* sum : {&error.rms_m, &error.rms_heading, &error.aligned_rms_m}) {
    *sum = std::sqrt(*sum / error.poses);
  }
  Vec2 last = to.front();
  for (const StampedPose& stamped : truth.poses()) {
    if (stamped.time_s <= begin_s || stamped.time_s >= end_s) continue;
    error.length_m += (stamped.pose.position() - last).norm();
    last = stamped.pose.position();
  }
  error.length_m += (to.back() - last).norm();
  return error;
}

}  // namespace handmap
