#include "core/explain/wall_story.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/explain/constants.h"
#include "core/map/certainty.h"

namespace handmap {

using namespace explain;

namespace {

std::optional<Segment> wallOf(const Map& map, std::size_t building, std::size_t wall) {
  if (building >= map.buildings.size()) return std::nullopt;
  const Polygon outline = map.buildings[building].footprint();
  if (wall >= outline.size()) return std::nullopt;
  return Segment{outline[wall], outline[(wall + 1) % outline.size()]};
}

struct Place {
  Pose2 pose;
  double travelled_m;
};

/// Where the robot was.
class DrivenTrajectory {
 public:
  explicit DrivenTrajectory(const std::vector<StampedPose>& poses) : poses_(poses) {
    double travelled = 0.0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (i > 0) travelled += (poses[i].pose.position() - poses[i - 1].pose.position()).norm();
      travelled_.push_back(travelled);
    }
  }

  std::optional<Place> at(double time_s) const {
    const auto next = std::ranges::lower_bound(poses_, time_s, {}, &StampedPose::time_s);
    if (next == poses_.end()) return std::nullopt;
    const auto i = static_cast<std::size_t>(next - poses_.begin());
    if (next->time_s == time_s) return Place{next->pose, travelled_[i]};
    if (i == 0) return std::nullopt;
    const StampedPose& before = poses_[i - 1];
    const double t = (time_s - before.time_s) / (next->time_s - before.time_s);
    return Place{interpolated(before.pose, next->pose, t), travelled_[i]};
  }

 private:
  const std::vector<StampedPose>& poses_;
  std::vector<double> travelled_;
};

/// The returns of a scan that lie on the wall and came from outside.
std::optional<WallWitness> witnessOf(const Scan& scan, const Pose2& pose, const Segment& wall,
                                     double tolerance_m) {
  WallWitness witness;
  witness.pose = pose;
  double weights = 0.0;
  double offsets = 0.0;
  double variances = 0.0;
  for (const Ray& ray : scan.rays) {
    const auto likely = static_cast<double>(ray.wall);
    if (!ray.returned || likely < kLeastWall) continue;
    const Vec2 direction = unitVector(pose.heading + static_cast<double>(ray.bearing));
    const Vec2 end = pose.position() + static_cast<double>(ray.range) * direction;
    const auto on = onWall(wall, end, direction, tolerance_m);
    if (!on) continue;
    const double sigma = std::max(kLeastSigma_m, static_cast<double>(ray.sigma) * on->cosine);
    const double weight = likely / (sigma * sigma);
    weights += weight;
    offsets += weight * on->offset_m;
    variances += weight * weight * sigma * sigma;
    witness.returns.push_back(end);
  }
  if (witness.returns.empty()) return std::nullopt;
  witness.offset_m = offsets / weights;
  witness.sigma_m = std::hypot(kShared_m, std::sqrt(variances) / weights);
  return witness;
}

/// Shares, pulls and sums, of the weight of each witness.
void weigh(const std::vector<double>& weights, WallStory& story) {
  const double of_drawing = 1.0 / std::pow(std::max(story.drawn_sigma_m, kLeastSigma_m), 2);
  double of_witnesses = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    of_witnesses += weights[i];
    story.seen_m += weights[i] * story.witnesses[i].offset_m;
  }
  if (of_witnesses > 0.0) {
    story.seen_m /= of_witnesses;
    story.seen_sigma_m = 1.0 / std::sqrt(of_witnesses);
  }
  story.drawn_share = of_drawing / (of_drawing + of_witnesses);
  story.explained_m = story.drawn_m;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    WallWitness& witness = story.witnesses[i];
    witness.share = weights[i] / (of_drawing + of_witnesses);
    witness.pull_m = witness.share * (witness.offset_m - story.drawn_m);
    story.explained_m += witness.pull_m;
    story.rays += witness.returns.size();
  }
}

}  // namespace

WallStory storyOf(const Map& drawing, const Map& refined,
                  const std::vector<StampedPose>& trajectory, std::span<const SeenScan> scans,
                  std::size_t building, std::size_t wall, double tolerance_m) {
  WallStory story;
  story.tolerance_m = tolerance_m;
  const auto now = wallOf(refined, building, wall);
  const auto drawn = wallOf(drawing, building, wall);
  if (!now || !drawn) return story;
  story.wall = *now;
  const SideEstimate stated = wallsOf(refined.buildings[building])[wall];
  story.sigma_m = stated.sigma;
  story.seen = stated.seen;
  const Vec2 apart = drawn->a + drawn->b - now->a - now->b;
  story.drawn_m = -0.5 * apart.dot(perpendicular((now->b - now->a).normalized()));
  const Uncertainty uncertainty = drawing.uncertaintyOf(drawing.buildings[building]);
  story.drawn_sigma_m = std::hypot(uncertainty.position, 0.5 * uncertainty.size);

  const DrivenTrajectory robot(trajectory);
  std::map<long, double> looks;  // by metre of the way: how many
  std::vector<long> metre_of;
  for (const SeenScan& seen : scans) {
    const auto place = robot.at(seen.time_s);
    if (!place || seen.scan == nullptr) continue;
    auto witness = witnessOf(*seen.scan, place->pose, *now, tolerance_m);
    if (!witness) continue;
    witness->time_s = seen.time_s;
    story.witnesses.push_back(std::move(*witness));
    metre_of.push_back(std::lround(std::floor(place->travelled_m / kOneLook_m)));
    looks[metre_of.back()] += 1.0;
  }
  std::vector<double> weights;
  for (std::size_t i = 0; i < story.witnesses.size(); ++i) {
    weights.push_back(1.0 / (std::pow(story.witnesses[i].sigma_m, 2) * looks[metre_of[i]]));
  }
  weigh(weights, story);
  std::ranges::stable_sort(story.witnesses, std::greater(), &WallWitness::share);
  return story;
}

}  // namespace handmap
