#include "drivers/odometry_lines/line_odometry.h"

#include <utility>

#include "core/base/error.h"
#include "drivers/odometry_lines/odometry_line.h"

namespace handmap {

namespace {

constexpr std::size_t kLongestLine = 512;
constexpr int kWatch_ms = 100;
constexpr double kSilence_s = 1.0;
constexpr double kGone_s = 5.0;  // a port may be open though nobody is there

}  // namespace

LineOdometry::LineOdometry(PortAddress address, RigClock clock, std::uint64_t seed, QObject* parent)
    : OdometrySensor(parent),
      clock_(std::move(clock)),
      port_(std::move(address), seed),
      lines_(kLongestLine) {
  connect(&port_, &BytePort::opened, this, [this] {
    lines_.clear();
    stream_.reconnected();
    last_line_s_ = clock_();
    timer_.start(kWatch_ms);
    tell(DeviceState::Connecting, QStringLiteral("waiting for the first odometry"));
  });
  connect(&port_, &BytePort::received, this, [this](const QByteArray& bytes) {
    lines_.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())},
                [this](std::string_view line) { take(line); });
  });
  connect(&port_, &BytePort::lost, this, [this](const QString& why) {
    timer_.stop();
    tell(DeviceState::Lost, why);
  });
  connect(&timer_, &QTimer::timeout, this, &LineOdometry::watch);
}

LineOdometry::~LineOdometry() { LineOdometry::close(); }

void LineOdometry::open() {
  if (told_.state() != DeviceState::Closed) return;
  tell(DeviceState::Connecting, QStringLiteral("opening the port of the odometry"));
  port_.open();
}

void LineOdometry::close() {
  if (told_.state() == DeviceState::Closed) return;
  timer_.stop();
  port_.close();
  tell(DeviceState::Closed, {});
}

void LineOdometry::take(std::string_view line) {
  const double now_s = clock_();
  std::optional<OdometryStream::Moved> told;
  try {
    const OdometryLine odometry = parseOdometryLine(line);
    last_line_s_ = now_s;
    told = stream_.take(odometry.stamp_s, odometry.pose, now_s);
  } catch (const Error& error) {
    ++refused_;
    stream_.refuse(QString::fromUtf8(error.what()));
  }
  if (told) {
    port_.delivers();
    tell(stream_.state(), stream_.detail());
    Q_EMIT moved(told->time_s, told->pose);
  } else if (told_.state() == DeviceState::Ready) {
    tell(stream_.state(), stream_.detail());
  }
}

void LineOdometry::watch() {
  const double silent_s = clock_() - last_line_s_;
  if (silent_s > kGone_s) {
    port_.giveUp(QStringLiteral("nothing that is odometry has come for %1 s").arg(kGone_s));
  } else if (silent_s > kSilence_s && told_.state() != DeviceState::Connecting) {
    tell(DeviceState::Degraded, QStringLiteral("no odometry has come for %1 s").arg(kSilence_s));
  }
}

void LineOdometry::tell(DeviceState state, const QString& detail) {
  if (told_.changes(state, detail)) Q_EMIT stateChanged(state, detail);
}

}  // namespace handmap
