#include "core/rig/rig_monitor.h"

#include <algorithm>
#include <chrono>

#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr double kRateOver_s = 2.0;
constexpr double kSilent_s = 0.7;
constexpr double kSilentPeriods = 3.0;  // of a slow device
constexpr std::size_t kMostReasons = 64;

/// A head speaks when it is asked only; all others deliver by themselves.
bool isSilent(const DeviceStatus& device) {
  if (device.role == DeviceRole::Head || !device.age_s) return false;
  const double periods_s = device.rate_hz > 0.0 ? kSilentPeriods / device.rate_hz : 0.0;
  return *device.age_s > std::max(kSilent_s, periods_s);
}

}  // namespace

const char* nameOf(DeviceRole role) {
  switch (role) {
    case DeviceRole::Odometry:
      return "odometry";
    case DeviceRole::Scanner:
      return "scanner";
    case DeviceRole::Camera:
      return "camera";
    case DeviceRole::Head:
      return "head";
    case DeviceRole::ToRos:
      return "to ROS";
    case DeviceRole::ToFoxglove:
      return "to Foxglove";
  }
  return "";
}

const char* nameOf(DeviceState state) {
  switch (state) {
    case DeviceState::Closed:
      return "closed";
    case DeviceState::Connecting:
      return "connecting";
    case DeviceState::Ready:
      return "ready";
    case DeviceState::Degraded:
      return "degraded";
    case DeviceState::Lost:
      return "lost";
  }
  return "";
}

RigStatus RigMonitor::status() const {
  const double now = clock_();
  const std::scoped_lock lock(mutex_);
  RigStatus status = status_;
  if (newest_observation_s_) status.observation_age_s = now - *newest_observation_s_;
  for (const Watched& watched : devices_) {
    DeviceStatus device = watched.status;
    if (device.count > 0) device.age_s = now - watched.newest_s;
    const bool silent = isSilent(device);
    if (silent) device.rate_hz = 0.0;
    if (silent && device.state == DeviceState::Ready) {
      device.state = DeviceState::Degraded;
      device.detail = phrase("silent for {:.1f} s", *device.age_s);
    }
    status.devices.push_back(std::move(device));
  }
  return status;
}

RigPreview RigMonitor::preview() const {
  const std::scoped_lock lock(mutex_);
  return preview_;
}

std::optional<StampedPose> RigMonitor::odometry() const {
  const std::scoped_lock lock(mutex_);
  return odometry_;
}

std::optional<OdometryFrames> RigMonitor::frames() const {
  const std::scoped_lock lock(mutex_);
  return frames_;
}

void RigMonitor::moved(double time_s, const Pose2& odometry) {
  const std::scoped_lock lock(mutex_);
  odometry_ = {time_s, odometry};
}

void RigMonitor::framed(const OdometryFrames& frames) {
  const std::scoped_lock lock(mutex_);
  frames_ = frames;
}

void RigMonitor::lookAround() {
  const std::scoped_lock lock(mutex_);
  look_around_ = true;
}

bool RigMonitor::takeLookAround() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(look_around_, false);
}

double RigMonitor::robotTime(double time_s) const {
  constexpr DeviceRole kOrder[] = {DeviceRole::Scanner, DeviceRole::Camera, DeviceRole::Odometry};
  const std::scoped_lock lock(mutex_);
  for (const DeviceRole role : kOrder) {
    const auto has = [role](const Watched& watched) {
      return watched.status.role == role && watched.ahead_s;
    };
    const auto found = std::find_if(devices_.begin(), devices_.end(), has);
    if (found != devices_.end()) return time_s + *found->ahead_s;
  }
  const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
  return now.count() - (clock_() - time_s);
}

RigMonitor::Watched* RigMonitor::find(DeviceRole role) {
  const auto found = std::find_if(devices_.begin(), devices_.end(), [role](const Watched& watched) {
    return watched.status.role == role;
  });
  return found == devices_.end() ? nullptr : &*found;
}

void RigMonitor::add(DeviceRole role) {
  const std::scoped_lock lock(mutex_);
  if (find(role) != nullptr) return;
  devices_.push_back({});
  devices_.back().status.role = role;
}

void RigMonitor::setState(DeviceRole role, DeviceState state, const std::string& detail) {
  const std::scoped_lock lock(mutex_);
  Watched* device = find(role);
  if (device == nullptr) return;
  device->status.state = state;
  device->status.detail = detail;
}

void RigMonitor::datum(DeviceRole role, double time_s) {
  const double now = clock_();
  const double measured_s =
      time_s <= now ? time_s : now;  // a clock that is off makes nothing young
  const std::scoped_lock lock(mutex_);
  Watched* device = find(role);
  if (device == nullptr) return;
  ++device->status.count;
  ++device->rate_count;
  device->newest_s = std::max(device->newest_s, measured_s);
  const double span = device->newest_s - device->rate_since_s;
  if (span < kRateOver_s) return;
  device->status.rate_hz = static_cast<double>(device->rate_count) / span;
  device->rate_since_s = device->newest_s;
  device->rate_count = 0;
}

void RigMonitor::stamped(DeviceRole role, double time_s, double stamp_s) {
  const std::scoped_lock lock(mutex_);
  if (Watched* device = find(role)) device->ahead_s = stamp_s - time_s;
}

void RigMonitor::refused(const std::string& reason, const std::string& detail) {
  const std::scoped_lock lock(mutex_);
  if (status_.refused.size() < kMostReasons || status_.refused.contains(reason)) {
    ++status_.refused[reason];
  }
  status_.last_refusal = detail.empty() ? reason : reason + ": " + detail;
}

void RigMonitor::observed(double time_s) {
  const std::scoped_lock lock(mutex_);
  newest_observation_s_ = time_s;
}

void RigMonitor::given() {
  const std::scoped_lock lock(mutex_);
  ++status_.given;
}

void RigMonitor::passedOver(long observations) {
  const std::scoped_lock lock(mutex_);
  status_.passed_over += observations;
}

void RigMonitor::setActivity(const std::string& words) {
  const std::scoped_lock lock(mutex_);
  status_.activity = words;
}

void RigMonitor::setRecording(const RecordingStatus& recording) {
  const std::scoped_lock lock(mutex_);
  status_.recording = recording;
}

void RigMonitor::show(const cv::Mat& left, const cv::Mat& right) {
  const std::scoped_lock lock(mutex_);
  preview_ = {preview_.number + 1, left, right, {}};
}

void RigMonitor::show(const std::vector<RangePoint>& points) {
  const std::scoped_lock lock(mutex_);
  preview_ = {preview_.number + 1, {}, {}, points};
}

}  // namespace handmap
