#include "drivers/virtual/virtual_devices.h"

#include <algorithm>

namespace handmap {

namespace {
constexpr int kOdometry_ms = 50;
constexpr int kScannerLooks_ms = 10;  // whether a scan is due
}  // namespace

VirtualOdometry::VirtualOdometry(std::shared_ptr<DriveClock> clock, Trajectory way,
                                 std::vector<Fault> faults)
    : clock_(std::move(clock)),
      way_(std::move(way)),
      line_(
          std::move(faults), DeviceRole::Odometry, clock_->rig(),
          [this](double time_s, const Pose2& pose) { Q_EMIT moved(time_s, pose); },
          [this](DeviceState state, const QString& detail) {
            Q_EMIT stateChanged(state, detail);
          }) {
  connect(&timer_, &QTimer::timeout, this, &VirtualOdometry::tick);
}

void VirtualOdometry::open() {
  clock_->start();
  line_.open();
  timer_.start(kOdometry_ms);
}

void VirtualOdometry::close() {
  timer_.stop();
  line_.close();
}

void VirtualOdometry::tick() {
  const double now = clock_->driveTime();
  const auto& poses = way_.poses();
  const double on_way = std::clamp(now, poses.front().time_s, poses.back().time_s);
  line_.pass(clock_->rigTime(now), *way_.at(on_way));
}

VirtualScanner::VirtualScanner(std::shared_ptr<DriveClock> clock,
                               std::unique_ptr<ObservationSource> source, double period_s,
                               std::vector<Fault> faults)
    : clock_(std::move(clock)),
      source_(std::move(source)),
      period_s_(period_s),
      next_(source_->next()),
      line_(
          std::move(faults), DeviceRole::Scanner, clock_->rig(),
          [this](double time_s, const std::vector<RangePoint>& points) {
            Q_EMIT scanned(time_s, points);
          },
          [this](DeviceState state, const QString& detail) {
            Q_EMIT stateChanged(state, detail);
          }) {
  connect(&timer_, &QTimer::timeout, this, &VirtualScanner::tick);
}

void VirtualScanner::open() {
  clock_->start();
  line_.open();
  timer_.start(kScannerLooks_ms);
}

void VirtualScanner::close() {
  timer_.stop();
  line_.close();
}

/// At the end of the route the robot stands and still sees what it saw last.
void VirtualScanner::tick() {
  if (clock_->driveTime() < due_s_) return;
  if (next_) {
    last_ = *next_->views.front().points;
    next_ = source_->next();
  }
  line_.pass(clock_->rigTime(due_s_), last_);
  due_s_ = next_ ? next_->time_s : due_s_ + period_s_;
}

}  // namespace handmap
