#include "core/estimation/buildings/box_finder.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/parallel.h"
#include "core/estimation/buildings/constants.h"

namespace handmap {

using namespace buildings;

namespace {

void change(Box& box, std::size_t parameter, double by) {
  if (parameter == kHeading) {
    box.heading += by;
  } else {
    box.reach[parameter] += by;
  }
}

/// The part of a wall of a box where a wall was found: from `begin` to `end`, from the pivot on.
struct Stretch {
  std::size_t wall;
  double begin;
  double end;
  std::size_t first() const { return (wall + 3) % 4; }   ///< the wall at the beginning
  std::size_t second() const { return (wall + 1) % 4; }  ///< and at the end
};

std::optional<Stretch> stretchOn(const Box& box, const FoundWall& wall) {
  const Vec2 middle = (wall.a + wall.b) / 2.0;
  const Vec2 outward = -perpendicular(unitVector(wall.heading()));
  const std::array<Vec2, 4> normals = box.normals();
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2& normal = normals[k];
    if (normal.dot(outward) < std::cos(kParallel)) continue;
    if (std::abs(normal.dot(middle - box.pivot) - box.reach[k]) > kNear_m) continue;
    Stretch stretch{k, 0.0, 0.0};
    const Vec2& along = normals[stretch.second()];
    stretch.begin = along.dot(wall.a - box.pivot);
    stretch.end = along.dot(wall.b - box.pivot);
    if (stretch.begin > box.reach[stretch.second()]) continue;
    if (stretch.end < -box.reach[stretch.first()]) continue;
    return stretch;
  }
  return std::nullopt;
}

/// Whether the frame says anything of it.
bool isLookedAt(const Box& box, const Frame& frame, const SensorModel& sensor) {
  const BoxView view(box, frame.pose);
  if (!view.inReach(sensor.rangeLimit())) return false;
  bool looked_at = false;
  view.forRays(frame.rays, [&](const FrameRay& ray) {
    if (looked_at) return;
    const Entry entry = view.entry(ray);
    looked_at = entry.distance >= 0.0F && sensor(ray.sight, entry.distance, kWallSlack_m) != 0.0F;
  });
  return looked_at;
}

double area(const Box& box) { return signedArea(box.polygon()); }

double commonArea(const Box& a, const Box& b) {
  const Rectangle first = a.rectangle();
  const Rectangle second = b.rectangle();
  const double reach =
      (std::hypot(first.width, first.depth) + std::hypot(second.width, second.depth)) / 2.0;
  if ((first.centre - second.centre).norm() > reach) return 0.0;
  return intersectionArea(a.polygon(), b.polygon());
}

bool collide(const Box& a, const Box& b) {
  return commonArea(a, b) > kCommonArea * std::min(area(a), area(b));
}

bool alike(const Box& a, const Box& b) {
  return commonArea(a, b) > kAlike * std::max(area(a), area(b));
}

}  // namespace

double BoxFinder::objective(const Box& box, BoxScorer& scorer) const {
  double prior = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double size = box.reach[axis] + box.reach[axis + 2];
    if (size < kLeastSize_m) return kImpossible;
    const double off = (size - kTypicalSize_m) / kTypicalSize_m;
    prior -= 0.5 * off * off;
  }
  return prior + scorer(box);
}

Box BoxFinder::seed(const FoundWall& wall) const {
  return {(wall.a + wall.b) / 2.0,
          wall.heading(),
          {wall.length() / 2.0, kTypicalSize_m, wall.length() / 2.0, 0.0}};
}

void BoxFinder::refine(FoundBox& found, double step_m, std::span<const Frame* const> frames,
                       const SensorModel& sensor) const {
  const double long_side =
      std::max(found.box.reach[0] + found.box.reach[2], found.box.reach[1] + found.box.reach[3]);
  BoxScorer scorer(found.box, frames, sensor);
  found.score = objective(found.box, scorer);
  for (double step = step_m; step >= kLeastStep_m; step /= 2.0) {
    for (std::size_t parameter = 0; parameter <= kHeading; ++parameter) {
      const double by = parameter == kHeading ? step / long_side : step;
      for (const double sign : {1.0, -1.0}) {
        bool better = false;
        for (int tries = 0; tries < kTries; ++tries) {
          Box changed = found.box;
          change(changed, parameter, sign * by);
          const double score = objective(changed, scorer);
          if (score <= found.score) break;
          found.box = changed;
          found.score = score;
          better = true;
        }
        if (better) break;
      }
    }
  }
}

void BoxFinder::locateUnseen(FoundBox& found, std::span<const Frame* const> frames,
                             const SensorModel& sensor) const {
  BoxScorer scorer(found.box, frames, sensor, 1);
  for (std::size_t k = 0; k < 4; ++k) {
    if (found.reachSigma(k) < kNear_m / 2.0) continue;
    const auto score_at = [&](double reach) {
      Box changed = found.box;
      changed.reach[k] = reach;
      return objective(changed, scorer);
    };
    double best = found.box.reach[k];
    double best_score = score_at(best);
    for (double off = -2.0 * kNear_m; off <= 2.0 * kNear_m; off += kNear_m / 4.0) {
      const double score = score_at(found.box.reach[k] + off);
      if (score <= best_score) continue;
      best = found.box.reach[k] + off;
      best_score = score;
    }
    const double drop = best_score - std::max(score_at(best - kNear_m), score_at(best + kNear_m));
    if (drop < kTelling) continue;
    found.box.reach[k] = best;
    found.setReachSigma(k, std::min(found.reachSigma(k), kNear_m / std::sqrt(2.0 * drop)));
  }
}

/// Whether the wall belongs to the box; where it tells of a longer or shorter one, the box follows.
bool BoxFinder::adopt(FoundBox& found, const FoundWall& wall, std::span<const Frame* const> frames,
                      const SensorModel& sensor) const {
  const auto stretch = stretchOn(found.box, wall);
  if (stretch) {
    const bool agrees = std::abs(stretch->begin + found.box.reach[stretch->first()]) < kAgreed_m &&
                        std::abs(stretch->end - found.box.reach[stretch->second()]) < kAgreed_m;
    if (agrees || !found.in_sight || found.predates(frames)) return true;
    BoxScorer scorer(found.box, frames, sensor);
    const Box before = found.box;
    for (int ends = 1; ends <= 3; ++ends) {
      Box changed = before;
      if (ends & 1) changed.reach[stretch->first()] = -stretch->begin;
      if (ends & 2) changed.reach[stretch->second()] = stretch->end;
      const double score = objective(changed, scorer);
      if (score < found.score + kGain) continue;
      found.box = changed;
      found.score = score;
    }
    return true;
  }
  const Polygon corners = found.box.polygon();
  return distanceTo(corners, wall.a) < kNear_m && distanceTo(corners, wall.b) < kNear_m;
}

std::vector<FoundBox> BoxFinder::split(const FoundBox& found, const std::vector<FoundWall>& walls,
                                       std::span<const Frame* const> frames,
                                       const SensorModel& sensor) const {
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<Stretch> stretches;
    for (const FoundWall& wall : walls) {
      const std::optional<Stretch> stretch = stretchOn(found.box, wall);
      if (stretch && stretch->wall == k) stretches.push_back(*stretch);
    }
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
    for (std::size_t i = 0; i + 1 < stretches.size(); ++i) {
      const double gap_begin = stretches[i].end;
      const double gap_end = stretches[i + 1].begin;
      if (gap_end - gap_begin < kLeastGap_m) continue;
      FoundBox low = found;
      FoundBox high = found;
      low.box.reach[stretches[i].second()] = gap_begin;
      high.box.reach[stretches[i].first()] = -gap_end;
      BoxScorer scorer(found.box, frames, sensor);
      if (objective(low.box, scorer) + objective(high.box, scorer) < found.score - kPromising) {
        continue;
      }
      refine(low, kPieceStep_m, frames, sensor);
      refine(high, kPieceStep_m, frames, sensor);
      if (low.score > kLeastScore && high.score > kLeastScore &&
          low.score + high.score > found.score + kGain) {
        return {low, high};
      }
    }
  }
  return {found};
}

void BoxFinder::refineAll(std::vector<FoundBox>& boxes, std::span<const Frame* const> frames,
                          const SensorModel& sensor) {
  parallelFor(boxes.size(), [&](std::size_t b) {
    if (!boxes[b].in_sight || !isLookedAt(boxes[b].box, *frames.back(), sensor)) return;
    FoundBox refined = boxes[b];
    refine(refined, kSettledStep_m, frames, sensor);
    if (!boxes[b].predates(frames) || refined.score > boxes[b].score) boxes[b] = refined;
  });
  prune(boxes);
}

void BoxFinder::update(std::vector<FoundBox>& boxes, const std::vector<FoundWall>& walls,
                       std::span<const Frame* const> frames, const SensorModel& sensor) {
  std::erase_if(rivals_, [&](const FoundBox& rival) {
    return !BoxView(rival.box, frames.back()->pose).inReach(sensor.rangeLimit());
  });
  int seeds = 0;
  for (const FoundWall& wall : walls) {
    bool explained = false;
    for (FoundBox& found : boxes) explained |= adopt(found, wall, frames, sensor);
    if (explained || ++seeds > kMostSeeds) continue;
    FoundBox found{seed(wall)};
    refine(found, kSeedStep_m, frames, sensor);
    if (found.score < kLeastScore) continue;
    found.id = newId();
    boxes.push_back(found);
  }
  std::vector<FoundBox> pieces;
  for (const FoundBox& found : boxes) {
    if (!found.in_sight || found.predates(frames)) {
      pieces.push_back(found);
      continue;
    }
    std::vector<FoundBox> parts = split(found, walls, frames, sensor);
    for (std::size_t i = 1; i < parts.size(); ++i) parts[i].id = newId();
    pieces.insert(pieces.end(), parts.begin(), parts.end());
  }
  boxes = std::move(pieces);
  prune(boxes);
}

void BoxFinder::prune(std::vector<FoundBox>& boxes) {
  std::stable_sort(boxes.begin(), boxes.end(), [](const FoundBox& a, const FoundBox& b) {
    return a.in_sight != b.in_sight ? b.in_sight : a.score > b.score;
  });
  boxes.insert(boxes.end(), rivals_.begin(), rivals_.end());
  rivals_.clear();
  const auto any = [](const std::vector<FoundBox>& others, auto relation, const FoundBox& found) {
    return std::any_of(others.begin(), others.end(),
                       [&](const FoundBox& other) { return relation(found.box, other.box); });
  };
  std::vector<FoundBox> kept;
  for (const FoundBox& found : boxes) {
    if (found.score < kLeastScore) continue;
    if (!any(kept, collide, found)) {
      kept.push_back(found);
    } else if (found.in_sight && rivals_.size() < kMostRivals && !any(rivals_, alike, found)) {
      rivals_.push_back(found);
    }
  }
  boxes = std::move(kept);
}

}  // namespace handmap
