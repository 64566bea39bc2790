#include "core/trajectory/scan_trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/median.h"
#include "core/trajectory/constants.h"
#include "core/trajectory/local_map_odometry.h"
#include "core/trajectory/returns.h"
#include "core/trajectory/scan_noise.h"
#include "core/trajectory/sharpness.h"
#include "core/trajectory/trajectory_graph.h"

namespace handmap {

using namespace trajectory;

namespace {

/// How far the motions of two ways are apart in heading, the median.
double usualTurnOff(const std::vector<Pose2>& trajectory, const std::vector<Pose2>& other) {
  std::vector<double> off;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const double turn = trajectory[i].heading - trajectory[i - 1].heading;
    off.push_back(std::abs(normalizedAngle(turn - (other[i].heading - other[i - 1].heading))));
  }
  return medianOf(std::move(off));
}

}  // namespace

struct ScanTrajectory::State {
  explicit State(const TrajectoryOptions& chosen) : options(chosen), graph(chosen.close_loops) {}

  void place();
  void look(const Returns& from);
  void thinOut();
  void judge();
  double chance() const;
  bool isFollowed() const { return 2 * followed > poses.size(); }
  void stateTurn();

  TrajectoryOptions options;
  LocalMapOdometry odometry;
  TrajectoryGraph graph;
  ScanNoise noise;
  std::vector<Pose2> recorded;
  std::vector<Pose2> smooth;
  std::vector<std::size_t> keyframe;  ///< the last one at each observation
  std::vector<Pose2> poses;
  std::vector<SharpnessFrame> seen;
  std::size_t followed = 0;  ///< motions that something told better than matching
  long returns = 0;
  long straight = 0;
  double look_m = kLook_m;              ///< between frames that sharpness is judged by
  std::size_t seen_count = 0;           ///< points in them
  std::optional<Vec2> looked_at;        ///< where the newest frame of `seen` was, recorded
  std::size_t judge_at = kFirstJudged;  ///< observations
  bool usable = false;                  ///< when it was judged
  bool joined = false;                  ///< what was seen, by an odometry
  std::size_t covariance_of = 0;        ///< keyframes
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  std::size_t turn_at = 1;  ///< keyframes, to be stated anew
  int turn_loops = 0;
  double turn = 0.0;
};

void ScanTrajectory::State::place() {
  poses.resize(smooth.size());
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    poses[i] = graph.corrected(smooth[i], keyframe[i]);
  }
}

void ScanTrajectory::State::look(const Returns& from) {
  seen.emplace_back();
  const Vec2 here = recorded.back().position();
  if (looked_at && (here - *looked_at).norm() < look_m) return;
  looked_at = here;
  seen.back() = sharpnessFrame(from, options.range_limit_m, noise);
  seen_count += seen.back()->size();
  if (seen_count > kMostSeen) thinOut();
}

/// Of a way of many kilometres every second look has to do.
void ScanTrajectory::State::thinOut() {
  look_m *= 2.0;
  seen_count = 0;
  bool keep = true;
  for (SharpnessFrame& frame : seen) {
    if (!frame || frame->empty()) continue;
    if (!keep) frame = nullptr;
    seen_count += frame ? frame->size() : 0;
    keep = !keep;
  }
}

/// What of the sharpness is chance: the more the noisier the ranges.
double ScanTrajectory::State::chance() const {
  return kClearlySharper * std::max(1.0, noise.sigma(kBin_m) / perception::kLaserSigma_m);
}

void ScanTrajectory::State::judge() {
  if (poses.size() < judge_at) return;
  judge_at = poses.size() + poses.size() / kJudgedAnew;
  const auto share = kLeastStraight * static_cast<double>(returns);
  const bool matched = straight > 0 && static_cast<double>(straight) >= share;
  usable = matched || isFollowed();
  if (!usable) return;
  const SharpnessOptions rough{.samples = kRoughSamples};
  const double needed = sharpnessOf(seen, recorded, rough) - (isFollowed() ? chance() : 0.0);
  usable = sharpnessOf(seen, poses, rough) >= needed;
}

/// A heading that strays evenly swings what is far by 1 / √3 of what it is off there.
void ScanTrajectory::State::stateTurn() {
  const std::size_t keyframes = graph.keyframes();
  if (keyframes < turn_at && graph.loops() == turn_loops) return;
  turn_at = keyframes + keyframes / kJudgedAnew;
  turn_loops = graph.loops();
  // A loop back to the start holds the end, least the middle.
  const auto of = graph.covariances(std::array{(keyframes - 1) / 2, keyframes - 1});
  turn = std::sqrt(std::max(of.front()(2, 2), of.back()(2, 2)) / 3.0);
}

ScanTrajectory::ScanTrajectory(const TrajectoryOptions& options)
    : state_(std::make_unique<State>(options)) {}
ScanTrajectory::~ScanTrajectory() = default;
ScanTrajectory::ScanTrajectory(ScanTrajectory&&) noexcept = default;
ScanTrajectory& ScanTrajectory::operator=(ScanTrajectory&&) noexcept = default;

void ScanTrajectory::add(double /*time_s*/, const Odometry& odometry,
                         const std::vector<RangePoint>& points, const std::stop_token& stop,
                         const std::vector<std::uint32_t>& ids, const std::optional<Pose2>& moved) {
  State& state = *state_;
  const Returns returns = usableReturns(points, state.options.range_limit_m);
  state.noise.add(returns.upright);
  const std::vector<ScanPoint> scan = features(returns, state.noise);
  state.returns += static_cast<long>(scan.size());
  state.straight +=
      std::count_if(scan.begin(), scan.end(), [](const ScanPoint& p) { return p.straight(); });
  const std::vector<TrackedPoint> tracked = trackedPoints(points, ids);
  state.odometry.add(odometry.pose, scan, tracked, moved);
  if (state.odometry.isFollowed()) ++state.followed;
  const Pose2 pose = state.odometry.pose();
  const bool closed = state.graph.add({pose, odometry.guessed},
                                      hasTracks() ? state.odometry.refined(tracked) : scan,
                                      state.odometry.variance(), stop);
  state.recorded.push_back(odometry.pose);
  state.smooth.push_back(pose);
  state.look(returns);
  state.keyframe.push_back(state.graph.keyframes() - 1);
  if (closed) {
    state.place();
  } else {
    state.poses.push_back(state.graph.corrected(pose, state.keyframe.back()));
  }
  state.judge();
  if (usable()) state.stateTurn();
}

void ScanTrajectory::add(double time_s, const Odometry& odometry, const Percept& percept,
                         const std::stop_token& stop) {
  if (percept.joined) setJoined();
  std::vector<RangePoint> walls;
  if (percept.points.empty()) walls = likelyWalls(percept.scan);
  add(time_s, odometry, walls.empty() ? percept.points : walls, stop, percept.ids, percept.moved);
}

Pose2 ScanTrajectory::odometry() const { return state_->odometry.pose(); }
const std::vector<Pose2>& ScanTrajectory::scanPoses() const { return state_->poses; }
const std::vector<Pose2>& ScanTrajectory::recorded() const { return state_->recorded; }

void ScanTrajectory::setJoined() { state_->joined = true; }

bool ScanTrajectory::usable() const { return state_->usable && (!state_->joined || hasTracks()); }

bool ScanTrajectory::hasTracks() const { return state_->odometry.hasTracks(); }

bool ScanTrajectory::isFollowed() const { return usable() && state_->isFollowed(); }

double ScanTrajectory::sharpness(const std::vector<Pose2>& trajectory) const {
  return sharpnessOf(state_->seen, trajectory);
}

std::function<double(const std::vector<Pose2>&)> ScanTrajectory::sharpnessLater() const {
  return [seen = state_->seen](const std::vector<Pose2>& trajectory) {
    return sharpnessOf(seen, trajectory);
  };
}

double ScanTrajectory::rangeNoise(double range_m) const { return state_->noise.sigma(range_m); }

double ScanTrajectory::noiseScale() const {
  if (!usable()) return 1.0;
  const double recorded = usualTurnOff(state_->recorded, state_->poses);
  const double scans = usualTurnOff(state_->smooth, state_->poses);
  return recorded > 0.0 ? std::clamp(scans / recorded, kLeastNoise, 1.0) : 1.0;
}

const Eigen::Matrix3d& ScanTrajectory::covariance() const {
  State& state = *state_;
  if (state.covariance_of != state.graph.keyframes()) {
    state.covariance_of = state.graph.keyframes();
    state.covariance = state.graph.covariance();
  }
  return state.covariance;
}

double ScanTrajectory::turn() const { return state_->turn; }

double ScanTrajectory::lengthScale() const { return state_->odometry.noise().lengthScale(); }
int ScanTrajectory::loops() const { return state_->graph.loops(); }

}  // namespace handmap
