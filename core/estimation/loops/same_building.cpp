#include "core/estimation/loops/same_building.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/buildings/constants.h"
#include "core/estimation/loops/constants.h"

namespace handmap {

using namespace loops;

std::vector<SharedParameter> compare(const FoundBox& old, const FoundBox& again) {
  const Box& a = old.box;
  const Box& b = again.box;
  const std::size_t quarters = b.quartersTo(a.heading);
  std::vector<SharedParameter> shared;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t j = (k + quarters) % 4;
    if (old.reachSigma(k) > kSeen_m || again.reachSigma(j) > kSeen_m) continue;
    SharedParameter wall;
    wall.old_parameter = k;
    wall.again_parameter = j;
    wall.normal = a.normal(k);
    wall.point = (b.corner(j) + b.corner((j + 3) % 4)) / 2.0;
    wall.error = a.reach[k] - wall.normal.dot(wall.point - a.pivot);
    wall.old_slope.setZero();
    wall.again_slope.setZero();
    wall.old_slope[static_cast<Eigen::Index>(k)] = 1.0;
    wall.old_slope[buildings::kHeading] = -perpendicular(wall.normal).dot(wall.point - a.pivot);
    wall.again_slope[static_cast<Eigen::Index>(j)] = -wall.normal.dot(b.normal(j));
    wall.again_slope[buildings::kHeading] = -wall.normal.dot(perpendicular(wall.point - b.pivot));
    wall.variance = old.reachSigma(k) * old.reachSigma(k) +
                    again.reachSigma(j) * again.reachSigma(j) + kWallFloor_m * kWallFloor_m;
    shared.push_back(wall);
  }
  if (shared.empty()) return shared;
  SharedParameter heading{buildings::kHeading,
                          buildings::kHeading,
                          std::remainder(a.heading - b.heading, kPi / 2.0),
                          {},
                          {},
                          Vec2::Zero(),
                          Vec2::Zero(),
                          old.heading_sigma * old.heading_sigma +
                              again.heading_sigma * again.heading_sigma +
                              kHeadingFloor * kHeadingFloor};
  heading.old_slope = Eigen::Matrix<double, 5, 1>::Unit(buildings::kHeading);
  heading.again_slope = -heading.old_slope;
  shared.push_back(heading);
  return shared;
}

FoundBox merged(const FoundBox& old, const FoundBox& again) {
  FoundBox result = old;
  const FoundBox turned = again.nearestTo(old.box.heading);
  for (std::size_t k = 0; k < 4; ++k) {
    if (turned.reachSigma(k) >= old.reachSigma(k)) continue;
    const Vec2 wall = turned.box.pivot + turned.box.reach[k] * turned.box.normal(k);
    result.box.reach[k] = old.box.normal(k).dot(wall - old.box.pivot);
    result.setReachSigma(k, turned.reachSigma(k));
  }
  result.score = again.score;
  result.in_sight = again.in_sight;
  result.last_frame = again.last_frame;
  result.dormant = false;
  return result;
}

std::vector<FoundBox> merged(std::span<const FoundBox> boxes, std::span<const SameBuilding> pairs) {
  std::vector<FoundBox> kept;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto pair = std::find_if(pairs.begin(), pairs.end(), [&](const SameBuilding& p) {
      return p.old == boxes[i].id || p.again == boxes[i].id;
    });
    if (pair == pairs.end()) {
      kept.push_back(boxes[i]);
    } else if (pair->old == boxes[i].id) {
      kept.push_back(merged(boxes[i], *findBox(boxes, pair->again)));
    }
  }
  return kept;
}

}  // namespace handmap
