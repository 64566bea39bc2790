#include "drivers/odometry_lines/line_odometry.h"

#include <utility>

#include "core/base/error.h"
#include "drivers/device/q_phrase.h"
#include "drivers/odometry_lines/odometry_line.h"

namespace handmap {

namespace {

constexpr std::size_t kLongestLine = 512;
constexpr int kWatch_ms = 100;
constexpr double kGone_s = 5.0;  // a port may be open though nobody is there

}  // namespace

LineOdometry::LineOdometry(PortAddress address, RigClock clock, std::uint64_t seed, QObject* parent)
    : PortDevice(std::move(address), std::move(clock), seed, kWatch_ms,
                 qPhrase("opening the port of the odometry"), parent),
      lines_(kLongestLine) {}

LineOdometry::~LineOdometry() { close(); }

void LineOdometry::begin() {
  lines_.clear();
  stream_.reconnected();
  last_line_s_ = now_s();
  tell(DeviceState::Connecting, qPhrase("waiting for the first odometry"));
}

void LineOdometry::take(const QByteArray& bytes) {
  lines_.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())},
              [this](std::string_view line) { take(line); });
}

void LineOdometry::take(std::string_view line) {
  const double arrival_s = now_s();
  if (asksToLook(line)) return lookAsked();
  std::optional<OdometryStream::Moved> told;
  try {
    const OdometryLine odometry = parseOdometryLine(line);
    last_line_s_ = arrival_s;
    told = stream_.take(odometry.stamp_s, odometry.pose, arrival_s);
  } catch (const Error& error) {
    ++refused_;
    stream_.refuse(QString::fromUtf8(error.what()));
  }
  if (told) {
    port().delivers();
    tell(stream_.state(), stream_.detail());
    Q_EMIT moved(told->time_s, told->pose);
  } else if (stateTold() == DeviceState::Ready) {
    tell(stream_.state(), stream_.detail());
  }
}

void LineOdometry::watch() {
  const double silent_s = now_s() - last_line_s_;
  if (silent_s > kGone_s) {
    port().giveUp(qPhrase("nothing that is odometry has come for {} s", kGone_s));
  } else if (silent_s > kSilence_s && stateTold() != DeviceState::Connecting) {
    tell(DeviceState::Degraded, qPhrase("no odometry has come for {} s", kSilence_s));
  }
}

}  // namespace handmap
