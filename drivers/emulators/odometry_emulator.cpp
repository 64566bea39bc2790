#include "drivers/emulators/odometry_emulator.h"

#include <utility>

#include <fmt/format.h>

namespace handmap {

OdometryEmulator::OdometryEmulator(EmulatedPort::Kind kind, PoseFunction pose, Form form,
                                   int interval_ms, std::uint64_t seed)
    : port_(kind, seed), pose_(std::move(pose)), form_(form) {
  connect(&timer_, &QTimer::timeout, this, &OdometryEmulator::sendLine);
  timer_.setTimerType(Qt::PreciseTimer);
  clock_.start();
  timer_.start(interval_ms);
}

void OdometryEmulator::sendLine() {
  if (dead_) return;
  const double time_s = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  const double stamp_s = time_s + clock_offset_s_;
  const Pose2 pose = pose_(time_s);
  if (form_ == Form::Json) {
    return port_.write(fmt::format(R"({{"t":{:.4f},"x":{:.4f},"y":{:.4f},"yaw":{:.5f}}})"
                                   "\n",
                                   stamp_s, pose.x, pose.y, pose.heading));
  }
  std::string line =
      fmt::format("odom,{:.4f},{:.4f},{:.4f},{:.5f}", stamp_s, pose.x, pose.y, pose.heading);
  if (form_ == Form::FieldsWithChecksum) {
    unsigned sum = 0;
    for (const char byte : line) sum ^= static_cast<unsigned char>(byte);
    line += fmt::format("*{:02X}", sum);
  }
  port_.write(line + "\n");
}

}  // namespace handmap
