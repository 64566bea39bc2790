#include "drivers/device/odometry_stream.h"

#include "drivers/device/q_phrase.h"

namespace handmap {

namespace {

constexpr double kRemark_s = 5.0;

}  // namespace

std::optional<OdometryStream::Moved> OdometryStream::take(double stamp_s, const Pose2& pose,
                                                          double arrival_s) {
  last_arrival_s_ = arrival_s;
  const int jumps = offset_.jumps();
  const int restarts = gate_.restarts();
  const std::optional<double> time_s = offset_.rigTime(stamp_s, arrival_s);
  if (!time_s) return std::nullopt;
  const std::optional<Pose2> passed = gate_.pass(*time_s, pose);
  if (offset_.jumps() != jumps) {
    why_ = qPhrase("the clock of the base was set anew");
    remark_until_s_ = arrival_s + kRemark_s;
  }
  if (gate_.restarts() != restarts) {
    why_ = qPhrase("the base began its odometry anew; what it did in between is not known");
    remark_until_s_ = arrival_s + kRemark_s;
  }
  if (!passed) {
    refuse(qPhrase("the base tells leaps that no robot can do"));
    return std::nullopt;
  }
  health_.good();
  return Moved{*time_s, *passed};
}

void OdometryStream::refuse(const QString& why) {
  health_.bad();
  why_ = why;
}

DeviceState OdometryStream::state() {
  const bool remark = last_arrival_s_ < remark_until_s_;
  return health_.degraded() || remark ? DeviceState::Degraded : DeviceState::Ready;
}

QString OdometryStream::detail() { return state() == DeviceState::Ready ? QString() : why_; }

}  // namespace handmap
