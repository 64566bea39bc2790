#include "core/estimation/estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/estimation/estimator_state.h"

namespace handmap {

namespace {

constexpr double kSlacks[] = {0.3, 0.1};  // across walls, metres: wide to catch, narrow to settle
constexpr double kFinalSlacks[] = {0.2, 0.1, 0.03};
constexpr int kMostIterations = 10;  // of the whole run
constexpr double kSettled = 0.02;    // metres: no pose moves any more
/// Frames whose odometry is never better than usual: the start is placed by hand, and the way has
/// to turn to the drawing somewhere.
constexpr std::size_t kFromStart = 10;
constexpr std::size_t kMostSmoothed = 300;  // of the buildings settled far away

}  // namespace

HandmapEstimator::HandmapEstimator(const Map& drawing, const EstimatorOptions& options,
                                   std::uint64_t seed) {
  requireReadyToRun(drawing);
  EstimatorOptions stated = options;
  stated.assignment = withStated(drawing.whole, options.assignment);
  state_ = std::make_unique<State>(drawing, stated, seed);
  state_->pose = *drawing.start;
  state_->correction.correctAll({}, state_->hasReached());
}

HandmapEstimator::~HandmapEstimator() = default;

void HandmapEstimator::startFrom(const Pose2& odometry) {
  state_->addFrame(0.0, odometry, *state_->drawing.start, Scan{});
}

void HandmapEstimator::reviseOdometry(const std::vector<Pose2>& odometry, double noise) {
  State& state = *state_;
  state.odometry_noise = noise;
  for (std::size_t i = 0; i < state.observations.size(); ++i) {
    State::Passing& passing = state.observations[i];
    Frame& frame = state.frames[passing.frame];
    if (i == 0 || state.observations[i - 1].frame != passing.frame) frame.odometry = odometry[i];
    passing.offset = between(frame.odometry, odometry[i]);
  }
  std::vector<Pose2> before;
  for (const Frame& frame : state.frames) before.push_back(frame.pose);
  for (std::size_t i = 1; i < state.frames.size(); ++i) {
    const Frame& last = state.frames[i - 1];
    Frame& frame = state.frames[i];
    frame.odometry_noise = i < kFromStart ? 1.0 : noise;
    frame.pose = last.pose * state.smoother.scaled(between(last.odometry, frame.odometry));
  }
  const auto move_with = [&](std::size_t frame, const Vec2& point) {
    return state.frames[frame].pose.toOuter(before[frame].toOwn(point));
  };
  const auto move = [&](FoundBox& found) {
    const std::size_t last = std::min(found.last_frame, state.frames.size() - 1);
    const std::size_t middle = (std::min(found.first_frame, last) + last) / 2;
    found.box.pivot = move_with(middle, found.box.pivot);
    found.box.heading += state.frames[middle].pose.heading - before[middle].heading;
  };
  for (FoundBox& found : state.found) move(found);
  state.labels.changeSettled(move);
  std::vector<bool> moved(state.landmarks.positions().size());
  for (std::size_t i = state.frames.size(); i-- > 0;) {
    for (const Sighting& sighting : state.frames[i].sightings) {
      const auto at = static_cast<std::size_t>(sighting.landmark);
      if (sighting.landmark < 0 || moved[at]) continue;
      Vec2& position = state.landmarks.positions()[at];
      position = move_with(i, position);
      moved[at] = true;
    }
  }
  state.evidence.putAnew(state.sensor);
  if (state.frames.empty()) return;
  state.pose = state.frames.back().pose;
  state.first_moved = 0;
  state.updateTrajectory();
}

void HandmapEstimator::step(double time_s, const Pose2& odometry, const Scan& scan,
                            const std::stop_token& stop,
                            const std::function<void(double)>& progress) {
  State& state = *state_;
  if (state.frames.empty()) startFrom(odometry);
  const Frame& last = state.frames.back();
  const Pose2 motion = between(last.odometry, odometry);
  const bool moved = std::hypot(motion.x, motion.y) >= state.options.key_step_m ||
                     std::abs(motion.heading) >= state.options.key_turn;
  state.pose = last.pose * state.smoother.scaled(motion);
  if (!moved && state.observations.empty()) {
    state.frames.pop_back();
  } else if (!moved) {
    state.addObservation(time_s, motion);
    return;
  }
  state.addFrame(time_s, odometry, state.pose, scan);
  state.addObservation(time_s, Pose2{});
  state.smoothWindow();
  state.workIn(stop, progress);
  state.pose = state.frames.back().pose;
  state.updateTrajectory();
}

/// What the newest frame tells. Once a stop is requested all that can wait is left out: no frame is
/// needed for the next one to be worked in.
void HandmapEstimator::State::workIn(const std::stop_token& stop,
                                     const std::function<void(double)>& progress) {
  odometry_estimate.add(frames);
  smoother.setHeadingVariance(odometry_estimate.headingVariance());
  if (progress) progress(0.4);
  if (stop.stop_requested()) return;
  evidence.add(frames.back(), sensor);
  updateDirections();
  if (stop.stop_requested()) return;
  findBuildings();
  followBuildings();
  if (!stop.stop_requested()) updateNoise();
  if (progress) progress(0.9);
  labelBuildings(nearM());  // they are labelled by their places among those that were found
  if (closeLoop(stop) || smoothNowAndThen(stop)) labelBuildings(nearM());
  if (stop.stop_requested()) return;
  if (fitOutlines()) labelBuildings(nearM());
  correction.correctSome(found, hasReached());
}

void HandmapEstimator::State::addObservation(double time_s, const Pose2& offset) {
  observations.push_back({time_s, frames.size() - 1, offset});
  poses.push_back({time_s, pose});
  trajectory = poses.share();
}

void HandmapEstimator::State::updateTrajectory() {
  for (std::size_t i = observations.size(); i-- > 0;) {
    const Passing& passing = observations[i];
    if (passing.frame < first_moved) break;
    poses.set(i, {passing.time_s, frames[passing.frame].pose * smoother.scaled(passing.offset)});
  }
  first_moved = frames.size();
  trajectory = poses.share();
}

void HandmapEstimator::State::addFrame(double time_s, const Pose2& odometry, const Pose2& at,
                                       const Scan& scan) {
  if (!scan.first_looked_at.empty() && !frames.empty()) {
    evidence.changeFrames(sensor, [&] {
      for (std::size_t i = firstKept(); i < frames.size(); ++i) {
        if (frames[i].ray_by_ray) addSilence(frames[i], scan.first_looked_at, sensor.rangeLimit());
      }
    });
  }
  frames.push_back(makeFrame(time_s, odometry, at, scan));
  frames.back().odometry_noise = frames.size() <= kFromStart ? 1.0 : odometry_noise;
  if (frames.size() > 1) {
    const Frame& before = frames[frames.size() - 2];
    frames.back().number = before.number + 1;
    frames.back().way_m = before.way_m + between(before.odometry, odometry).position().norm();
  }
  frames.back().sightings = compactThings(frames.back().rays, sensor);
  landmarks.associate(frames.back(), sensor.options().noise,
                      static_cast<std::size_t>(options.most_active));
  if (const std::size_t kept = firstKept(); kept > 0) {
    frames[kept - 1].rays = {};
    frames[kept - 1].sightings = {};
  }
}

std::size_t HandmapEstimator::State::firstWorkedOn() const {
  const auto most = static_cast<std::size_t>(options.most_active);
  return frames.size() > most ? frames.size() - most : 0;
}

/// Older frames keep their pose alone.
std::size_t HandmapEstimator::State::firstKept() const {
  const auto most = static_cast<std::size_t>(options.most_kept);
  return frames.size() > most ? frames.size() - most : 0;
}

std::vector<Frame*> HandmapEstimator::State::framesFrom(std::size_t first) {
  std::vector<Frame*> some;
  for (std::size_t i = first; i < frames.size(); ++i) some.push_back(&frames[i]);
  return some;
}

bool HandmapEstimator::State::isInSight(const FoundBox& box) const {
  return !box.asleep && isInReach(box);
}

bool HandmapEstimator::State::isInReach(const FoundBox& box) const {
  return BoxView(box.box, frames.back().pose).inReach(options.range_limit_m);
}

MapCorrection::HasReached HandmapEstimator::State::hasReached() const {
  return [this](const Rectangle& box) {
    const Polygon corners = box.corners();
    return std::any_of(frames.begin(), frames.end(), [&](const Frame& frame) {
      return distanceTo(corners, frame.pose.position()) < options.range_limit_m;
    });
  };
}

void HandmapEstimator::State::smoothWindow() {
  std::vector<FoundBox> boxes;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!isInSight(found[i])) continue;
    found[i].last_frame = frames.back().number;
    boxes.push_back(found[i]);
    which.push_back(i);
  }
  std::vector<Frame*> window = framesFrom(firstWorkedOn());
  const auto count = static_cast<std::size_t>(options.window);
  const std::size_t fixed = window.size() > count ? window.size() - count : 1;
  first_moved = std::min(first_moved, frames.size() - (window.size() - fixed));
  const SmoothingGraph graph{window, fixed, boxes, landmarks.positions()};
  for (const double slack : kSlacks) smoother.iterate(graph, slack);
  const Eigen::Matrix3d since = smoother.covariances(boxes);
  carryCovariance(frames.size() - window.size() + fixed - 1, since);
  for (std::size_t i = 0; i < which.size(); ++i) found[which[i]] = boxes[i];
}

/// What is known of the newest pose since frame `from`, which is itself uncertain.
void HandmapEstimator::State::carryCovariance(std::size_t from, const Eigen::Matrix3d& since) {
  covariances.resize(frames.size(), Eigen::Matrix3d::Zero());
  const Vec2 lever = frames.back().pose.position() - frames[from].pose.position();
  Eigen::Matrix3d slope = Eigen::Matrix3d::Identity();
  slope.topRightCorner<2, 1>() = perpendicular(lever);
  covariance = slope * covariances[from] * slope.transpose() + since;
  covariances.back() = covariance;
}

/// After all poses were smoothed together: the window's are no surer than the newest.
void HandmapEstimator::State::renewCovariance() {
  covariance = smoother.covariances({});
  covariances.resize(frames.size(), Eigen::Matrix3d::Zero());
  const auto count = std::min(covariances.size(), static_cast<std::size_t>(options.window) + 1);
  std::fill(covariances.end() - static_cast<std::ptrdiff_t>(count), covariances.end(), covariance);
}

void HandmapEstimator::State::updateDirections() {
  const Vec2 here = frames.back().pose.position();
  const DrawingMotion& motion = labels.motion();
  std::vector<double> drawn;
  for (const std::size_t b : labels.nearby()) {
    const Building& building = drawing.buildings[b];
    const Rectangle box = building.box();
    const double reach = options.range_limit_m + 0.5 * std::hypot(box.width, box.depth) +
                         drawing.uncertaintyOf(building).position;
    if ((motion(box.centre) - here).norm() < reach)
      drawn.push_back(box.heading + labels.freeTurn());
  }
  directions.update(drawn, evidence.frames(), sensor, evidence.evidence());
  smoother.expectHeadings(directions.drawn(), labels.headingScatter(found));
}

void HandmapEstimator::State::updateNoise() {
  noise.add(frames.back(), found, sensor);
  clutter.add(frames.back(), found, sensor);
  smoother.setSystematic(noise.systematic());
  SensorOptions changed = sensor.options();
  changed.noise = noise.fitted(changed.noise);
  changed.noise.bias_per_m = smoother.biasPerMetre();
  changed.clutter = clutter.measured();
  if (differMuch(changed.noise, sensor.options().noise) ||
      differMuch(changed.clutter, sensor.options().clutter)) {
    evidence.changeSensor(sensor, changed);
  }
}

void HandmapEstimator::State::findBuildings() {
  const std::vector<FoundWall> walls = detectWalls(
      evidence.evidence(), frames.back().pose.position(), options.range_limit_m, options.detection);
  const std::vector<Frame*> last = framesFrom(firstWorkedOn());
  for (FoundBox& box : found) box.in_sight = isInSight(box);
  const auto asleep = std::stable_partition(found.begin(), found.end(),
                                            [](const FoundBox& box) { return !box.asleep; });
  const std::vector<FoundBox> aside(asleep, found.end());
  found.erase(asleep, found.end());
  finder.update(found, walls, {last.begin(), last.end()}, sensor);
  found.insert(found.end(), aside.begin(), aside.end());
}

/// What has been out of sight for long falls asleep: the way may have drifted since. It wakes where
/// something is in sight that was there before it fell asleep.
void HandmapEstimator::State::followBuildings() {
  const std::size_t now = frames.back().number;
  std::size_t oldest = now;
  for (FoundBox& box : found) {
    if (box.last_frame > now) {  // a new one
      box.first_frame = frames[firstWorkedOn()].number;
      box.last_frame = now;
    }
    if (isInSight(box)) {
      box.last_frame = now;
      oldest = std::min(oldest, box.first_frame);
    } else if (box.last_frame + static_cast<std::size_t>(options.most_active) < now) {
      box.asleep = true;
    }
  }
  for (FoundBox& box : found) {
    if (!box.asleep || box.last_frame < oldest || !isInReach(box)) continue;
    box.asleep = false;
    box.last_frame = now;
  }
}

/// Where the way has come back to what is asleep: finds out how far it has drifted. Returns whether
/// it did; the labels are then to be found anew.
bool HandmapEstimator::State::closeLoop(const std::stop_token& stop) {
  if (stop.stop_requested()) return false;
  constexpr double kShift = 0.01;  // of the way since; one σ
  constexpr double kLeastShift = 1.0;
  constexpr double kTurn = 0.0001;  // radians a metre
  constexpr double kLeastTurn = 0.03;
  constexpr double kWide[] = {0.5, 0.1};
  const Frame& here = frames.back();
  DriftPrior drift{here.pose.position(), 0.0, 0.0};
  std::vector<FoundBox> again;
  std::vector<std::size_t> again_at;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (isInSight(found[i])) {
      again.push_back(found[i]);
      again_at.push_back(i);
    } else if (found[i].asleep) {
      const double way = here.way_m - frames[found[i].last_frame].way_m;
      const double shift = kLeastShift + kShift * way;
      const double distance = (found[i].box.rectangle().centre - drift.here).norm();
      if (distance > options.range_limit_m + 2.0 * shift) continue;
      drift.shift_m = std::max(drift.shift_m, shift);
      drift.turn = std::max(drift.turn, kLeastTurn + kTurn * way);
    }
  }
  if (drift.shift_m == 0.0 || again.size() < 2) return false;
  const auto drawn_of = labels.recognise(again, drift.here, drift.shift_m);
  std::vector<SameBuilding> candidates;
  for (std::size_t old = 0; old < found.size(); ++old) {
    const auto drawn = labels.drawnOf(old);
    if (!found[old].asleep || !drawn) continue;
    for (std::size_t i = 0; i < again.size(); ++i) {
      if (drawn_of[i] == drawn) candidates.push_back({old, again_at[i]});
    }
  }
  const auto pairs = handmap::closeLoop(found, candidates, drift);
  if (!pairs) return false;
  smoothAll(kWide, kMostIterations, *pairs, stop);
  found = merged(found, *pairs);
  evidence.putAnew(sensor, stop);
  return true;
}

/// The window alone drifts. The longer the run the more seldom, so that a frame costs the same.
bool HandmapEstimator::State::smoothNowAndThen(const std::stop_token& stop) {
  constexpr std::size_t kLeast = 25;  // frames
  constexpr std::size_t kShare = 8;   // of the run so far
  constexpr double kSlack[] = {0.1};
  constexpr int kIterations = 3;
  if (stop.stop_requested()) return false;
  if (frames.size() < smoothed_at + std::max(kLeast, smoothed_at / kShare)) return false;
  smoothAll(kSlack, kIterations, {}, stop);
  evidence.putAnew(sensor, stop);
  return true;
}

/// All poses and boxes together, with each slack until nothing moves any more or so many times.
/// `same`: of `found`.
void HandmapEstimator::State::smoothAll(std::span<const double> slacks, int iterations,
                                        std::span<const SameBuilding> same,
                                        const std::stop_token& stop) {
  std::vector<FoundBox> all = allFound();
  const std::size_t settled = all.size() - found.size();
  const std::vector<Frame*> kept = framesFrom(firstKept());
  std::vector<SameBuilding> same_of_all;
  for (const SameBuilding& pair : same) {
    same_of_all.push_back({pair.old + settled, pair.again + settled});
  }
  DrawingPrior prior = labels.prior(kMostSmoothed, found.size());
  const SmoothingGraph graph{kept, 1, all, landmarks.positions(), same_of_all, &prior};
  for (const double slack : slacks) {
    for (int i = 0; i < iterations; ++i) {
      if (stop.stop_requested() || smoother.iterate(graph, slack, stop) < kSettled) break;
    }
  }
  smoothed_at = frames.size();
  if (!stop.stop_requested()) renewCovariance();
  first_moved = 0;
  setAllFound(all);
}

/// What is settled far away, then what is found.
std::vector<FoundBox> HandmapEstimator::State::allFound() const {
  std::vector<FoundBox> all = labels.settled(kMostSmoothed);
  all.insert(all.end(), found.begin(), found.end());
  return all;
}

void HandmapEstimator::State::setAllFound(const std::vector<FoundBox>& all) {
  const auto first = all.end() - static_cast<std::ptrdiff_t>(found.size());
  labels.setSettled({all.begin(), first});
  found.assign(first, all.end());
}

void HandmapEstimator::State::labelBuildings(double near_m) {
  constexpr std::size_t kLast = 200;  // frames
  std::vector<Pose2> way;
  for (std::size_t i = frames.size() - std::min(frames.size(), kLast); i < frames.size(); ++i) {
    way.push_back(frames[i].pose);
  }
  labels.update(found, way, near_m);
}

/// Gives what was found for a drawn polygon the outline of that. Returns whether anything changed:
/// the labels are then to be found anew.
bool HandmapEstimator::State::fitOutlines() {
  constexpr std::array<int, 4> kTries = {3, 6, 12, 24};  // frames that have seen the building
  const std::vector<Frame*> last = framesFrom(firstWorkedOn());
  const std::span<const Frame* const> frames_seen(last.begin(), last.end());
  bool changed = false;
  for (const std::size_t b : labels.nearby()) {
    const std::optional<std::size_t> at = labels.indexOf(b);
    if (!at || !found[*at].in_sight || found[*at].box.outline == outlines[b]) continue;
    FoundBox& box = found[*at];
    if (box.box.outline) {  // that of another drawn building
      box.box.outline = nullptr;
      finder.refine(box, 0.5, frames_seen, sensor);
      changed = true;
      continue;
    }
    if (std::find(kTries.begin(), kTries.end(), box.observations) == kTries.end()) continue;
    const Rectangle drawn = drawing.buildings[b].box();
    box = box.nearestTo(drawn.heading + labels.motion().turn());
    changed |=
        finder.replace(found, *at, placements(box.box, outlines[b], drawn), frames_seen, sensor);
  }
  if (changed) finder.prune(found);
  return changed;
}

void HandmapEstimator::finish(const std::stop_token& stop) {
  constexpr std::size_t kMostLabelled = 60;  // buildings that are labelled all together
  State& state = *state_;
  if (state.frames.empty()) return;
  state.smoothAll(kFinalSlacks, kMostIterations, {}, stop);
  state.updateTrajectory();
  if (stop.stop_requested()) return;
  std::vector<FoundBox> all = state.allFound();
  state.covariance = state.smoother.covariances(all);
  const std::vector<Frame*> frames = state.framesFrom(state.firstKept());
  for (FoundBox& found : all) {
    if (stop.stop_requested()) return;
    state.finder.locateUnseen(found, {frames.begin(), frames.end()}, state.sensor);
  }
  state.setAllFound(all);
  const bool few = state.labels.settledCount() + state.found.size() <= kMostLabelled &&
                   state.drawing.buildings.size() <= 2 * kMostLabelled;
  state.labelBuildings(few ? std::numeric_limits<double>::infinity() : state.nearM());
  state.correction.correctAll(state.found, state.hasReached());
  state.pose = state.frames.back().pose;
}

}  // namespace handmap
