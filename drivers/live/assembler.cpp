#include "drivers/live/assembler.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/phrase.h"
#include "core/recording/repeated_scan.h"

namespace handmap {

namespace {

/// Older than that it was held up somewhere, and the time stamp may be wrong too.
constexpr double kLatest_s = 2.0;
constexpr double kFuture_s = 0.1;
/// Beyond the time between two odometries; nobody wants to wait longer.
constexpr double kOdometryPatience_s = 0.5;
/// So long what the robot sees with may be silent, and so often it is told then where it drove.
constexpr double kBlind_s = 1.0;
constexpr double kBlindEvery_s = 0.25;
constexpr std::size_t kMostWaiting = 100;  // of 40 a second, while odometry comes once a second
constexpr std::size_t kMostWaitingBytes = 256U << 20U;
constexpr std::size_t kMostPoints = 500'000;

bool isFinite(const Pose2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

std::size_t bytesOf(const View& view) {
  const auto image = [](const cv::Mat& m) { return m.total() * m.elemSize(); };
  const std::size_t points = view.points ? view.points->size() * sizeof(RangePoint) : 0;
  return image(view.left) + image(view.right) + points;
}

}  // namespace

std::vector<RangePoint> inRobotFrame(const std::vector<RangePoint>& points,
                                     const ScannerMount& mount) {
  const Pose2 pose{mount.x, mount.y, mount.yaw};
  std::vector<RangePoint> moved;
  moved.reserve(points.size());
  for (const RangePoint& p : points) {
    const bool usable = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) &&
                        p.w >= 0.0F && p.w <= 1.0F;
    if (!usable) continue;
    if (!isMeasured(p)) {  // a direction, seen from the robot as from the scanner
      const double bearing = mount.yaw + std::atan2(p.y, p.x);
      moved.push_back(notMeasured(bearing, p.z + static_cast<float>(mount.z)));
      continue;
    }
    const Vec2 at = pose.toOuter({p.x, p.y});
    moved.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()),
                     p.z + static_cast<float>(mount.z), p.w});
  }
  return moved;
}

Assembler::Assembler(const Rig& rig, Sinks sinks) : rig_(rig), sinks_(std::move(sinks)) {
  if (rig.head) stops_.emplace(rig.stops.value_or(sixPans()));
}

bool Assembler::isTimely(double time_s, double& newest_s, double now_s, Word what) {
  std::string wrong;
  if (!std::isfinite(time_s) || time_s > now_s + kFuture_s) {
    wrong = phrase("{} stamped in the future", what());
  } else if (time_s < now_s - kLatest_s) {
    wrong = phrase("{} late", what());
  } else if (time_s <= newest_s) {
    wrong = phrase("{} repeated or out of order", what());
  }
  if (!wrong.empty()) {
    sinks_.refused(wrong);
    return false;
  }
  newest_s = time_s;
  return true;
}

void Assembler::moved(double time_s, const Pose2& pose, double now_s) {
  if (!isFinite(pose)) return sinks_.refused(phrase("odometry that is not finite"));
  if (!isTimely(time_s, newest_odometry_s_, now_s, [] { return phrase("odometry"); })) return;
  odometry_.add(time_s, pose);
  settle(now_s);
  if (stops_) act(stops_->moved(time_s, pose, odometry_.standingFor()));
}

void Assembler::scanned(double time_s, const std::vector<RangePoint>& points, double now_s) {
  if (!rig_.scanner) return;
  if (points.size() > kMostPoints) return sinks_.refused(phrase("scan with too many points"));
  if (!isTimely(time_s, newest_view_s_, now_s, [] { return phrase("scan"); })) return;
  View view;
  view.points = inRobotFrame(points, rig_.scanner->mount);
  if (std::none_of(view.points->begin(), view.points->end(), isMeasured)) {
    return sinks_.refused(phrase("scan without a single return"));
  }
  addMoving(time_s, std::move(view));
  settle(now_s);
}

void Assembler::pairTaken(double time_s, const cv::Mat& left, const cv::Mat& right, double now_s) {
  if (!rig_.camera) return;
  if (!isTimely(time_s, newest_view_s_, now_s, [] { return phrase("pair of images"); })) return;
  if (!stops_) {
    addMoving(time_s, {0.0, left, right, std::nullopt});
    return settle(now_s);
  }
  const auto action = stops_->pairTaken(time_s);
  if (!action) return;
  if (stop_views_.empty()) stop_time_s_ = time_s;
  stop_views_.push_back({action->pan, left, right, std::nullopt});
  act(stops_->tick(now_s));
}

void Assembler::headArrived(double pan, double now_s) {
  if (stops_) act(stops_->arrived(now_s, pan));
}

void Assembler::headLost() {
  if (stops_) act(stops_->headLost());
}

void Assembler::lookAround() {
  if (stops_) stops_->trigger();
}

void Assembler::tick(double now_s) {
  settle(now_s);
  goOnBlind(now_s);
  if (stops_) act(stops_->tick(now_s));
}

void Assembler::addMoving(double time_s, View view) {
  waiting_bytes_ += bytesOf(view);
  waiting_.push_back({time_s, std::move(view)});
  while (waiting_.size() > kMostWaiting || waiting_bytes_ > kMostWaitingBytes) {
    takeWaiting();
    sinks_.refused(phrase("too many observations that wait for odometry"));
  }
}

Assembler::Waiting Assembler::takeWaiting() {
  Waiting first = std::move(waiting_.front());
  waiting_.pop_front();
  waiting_bytes_ -= bytesOf(first.view);
  return first;
}

/// Gives out what has its odometry by now, in order, and gives up on what waited too long.
void Assembler::settle(double now_s) {
  while (!waiting_.empty()) {
    const double time_s = waiting_.front().time_s;
    const std::optional<Pose2> pose = rig_.odometry.isMeasured() ? odometry_.at(time_s) : Pose2{};
    const bool may_come =
        time_s > newest_odometry_s_ && now_s - time_s < kOdometryPatience_s + odometry_.period_s();
    if (!pose && may_come) return;
    Waiting ready = takeWaiting();
    if (!pose) {
      sinks_.refused(odometry_.isAround(time_s)
                         ? phrase("odometry too far apart around an observation")
                         : phrase("no odometry at the time of an observation"));
      continue;
    }
    if (isFrozen(ready.view, *pose)) {
      sinks_.refused(phrase("the same scan again, though the robot has moved"));
      continue;
    }
    std::vector<View> views;
    views.push_back(std::move(ready.view));
    deliver(time_s, *pose, false, std::move(views));
  }
}

/// What the robot sees with is silent, but it drives on: it is where its odometry says, ever less
/// surely. Between two stops that is as it should be.
void Assembler::goOnBlind(double now_s) {
  if (stops_ || delivered_s_ < 0.0 || now_s < blind_at_s_) return;
  const auto& newest = odometry_.newest();
  const bool measured = rig_.odometry.isMeasured();
  if (measured && (!newest || newest->time_s <= delivered_s_)) return;
  if (!measured && !rig_.scanner) return;
  std::vector<View> views;
  if (rig_.scanner) {
    const auto height = static_cast<float>(rig_.scanner->mount.z);
    views.push_back({0.0, {}, {}, std::vector{notMeasured(0.0, height)}});
  }
  deliver(measured ? newest->time_s : now_s, measured ? newest->pose : Pose2{}, false,
          std::move(views));
  blind_at_s_ = now_s + kBlindEvery_s;
}

bool Assembler::isFrozen(const View& view, const Pose2& pose) {
  if (!view.points) return false;
  if (isRepeated(newest_points_, *view.points)) {
    return isElsewhere(between(newest_points_from_, pose));
  }
  newest_points_ = *view.points;
  newest_points_from_ = pose;
  return false;
}

void Assembler::deliver(double time_s, const Pose2& pose, bool standing, std::vector<View> views) {
  if (time_s <= delivered_s_) return sinks_.refused(phrase("observation out of order"));
  delivered_s_ = time_s;
  blind_at_s_ = time_s + kBlind_s;
  Observation observation;
  observation.frame = frame_++;
  observation.time_s = time_s;
  observation.standing = standing;
  observation.odometry = pose;
  observation.views = std::move(views);
  sinks_.whole(std::move(observation));
}

void Assembler::act(std::optional<StopScan::Action> action) {
  if (!action) return;
  using Kind = StopScan::Action::Kind;
  switch (action->kind) {
    case Kind::Look:
      return sinks_.look(action->pan);
    case Kind::Take:
      return;  // pairTaken() has the images
    case Kind::Deliver:
      deliver(stop_time_s_, action->pose, true, std::exchange(stop_views_, {}));
      return sinks_.look(0.0);
    case Kind::Drop:
      stop_views_.clear();
      sinks_.refused(phrase("look around: {}", action->reason));
      return sinks_.look(action->pan);
  }
}

}  // namespace handmap
