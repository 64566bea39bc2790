#include "drivers/scanner/rplidar_scanner.h"

#include <algorithm>
#include <utility>

namespace handmap {

namespace {

using rplidar::Answer;
using rplidar::Request;

constexpr int kWatch_ms = 50;
constexpr double kQuiet_s = 0.1;  // until what was still under way has come
constexpr double kReset_s = 2.5;  // it starts its own computer anew
constexpr double kPatience_s = 1.0;
constexpr double kSpinUp_s = 4.0;  // until the motor turns evenly
constexpr double kSilence_s = 1.0;
constexpr int kMostAttempts = 4;
constexpr std::uint8_t kHealthError = 2;

std::string littleEndian(unsigned value) {
  return {static_cast<char>(value & 0xffU), static_cast<char>(value >> 8U & 0xffU)};
}

}  // namespace

RplidarScanner::RplidarScanner(PortAddress address, RigClock clock, std::uint64_t seed,
                               QObject* parent)
    : RangeSensor(parent), clock_(std::move(clock)), port_(std::move(address), seed) {
  connect(&port_, &BytePort::opened, this, [this] {
    attempts_ = 0;
    timer_.start(kWatch_ms);
    go(Step::Stopping);
  });
  connect(&port_, &BytePort::received, this, [this](const QByteArray& bytes) {
    take(reader_.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())}));
  });
  connect(&port_, &BytePort::lost, this, [this](const QString& why) {
    step_ = Step::Closed;
    timer_.stop();
    tell(DeviceState::Lost, why);
  });
  connect(&timer_, &QTimer::timeout, this, &RplidarScanner::watch);
}

RplidarScanner::~RplidarScanner() { RplidarScanner::close(); }

void RplidarScanner::open() {
  if (told_.state() != DeviceState::Closed) return;
  tell(DeviceState::Connecting, QStringLiteral("opening the port of the scanner"));
  port_.open();
}

void RplidarScanner::close() {
  if (told_.state() == DeviceState::Closed) return;
  if (step_ != Step::Closed) {
    port_.write(rplidar::request(Request::Stop));
    motor(false);
  }
  step_ = Step::Closed;
  timer_.stop();
  port_.close();
  tell(DeviceState::Closed, {});
}

// Each series has its own switch, and passes over those of the others.
void RplidarScanner::motor(bool on) {
  constexpr unsigned kPwm = 660;  // the maker's default, of 1023
  constexpr unsigned kTurnsAMinute = 600;
  port_.setDataTerminalReady(!on);
  port_.write(rplidar::request(Request::MotorPwm, littleEndian(on ? kPwm : 0)));
  port_.write(rplidar::request(Request::MotorSpeed, littleEndian(on ? kTurnsAMinute : 0)));
}

void RplidarScanner::go(Step step) {
  step_ = step;
  step_since_s_ = clock_();
  switch (step) {
    case Step::Closed:
      return;
    case Step::Stopping:
      tell(DeviceState::Connecting, QStringLiteral("asking the scanner what it is"));
      return port_.write(rplidar::request(Request::Stop));
    case Step::Identifying:
      reader_.clear();
      return port_.write(rplidar::request(Request::GetInfo));
    case Step::Examining:
      return port_.write(rplidar::request(Request::GetHealth));
    case Step::Resetting:
      tell(DeviceState::Degraded, QStringLiteral("the scanner reports an error and is reset"));
      return port_.write(rplidar::request(Request::Reset));
    case Step::StartingExpress:
      motor(true);
      return port_.write(rplidar::request(Request::ExpressScan, std::string(5, '\0')));
    case Step::StartingPlain:
      port_.write(rplidar::request(Request::Stop));
      return port_.write(rplidar::request(Request::Scan));
    case Step::Scanning:
      turns_.clear();
      last_turn_s_ = 0.0;
      return;
  }
}

void RplidarScanner::take(const RplidarReader::Events& events) {
  if (step_ == Step::Identifying && events.info) {
    model_ = QStringLiteral("RPLIDAR model 0x%1")
                 .arg(static_cast<unsigned char>(events.info->front()), 2, 16, QLatin1Char('0'));
    return go(Step::Examining);
  }
  if (step_ == Step::Examining && events.health) {
    return go(*events.health == kHealthError ? Step::Resetting : Step::StartingExpress);
  }
  const bool starting = step_ == Step::StartingExpress || step_ == Step::StartingPlain;
  if (starting && events.began && *events.began != Answer::Info &&
      *events.began != Answer::Health) {
    go(Step::Scanning);
  }
  if (step_ != Step::Scanning) return;
  for (const rplidar::Measurement& measurement : events.measurements) {
    if (const auto points = turns_.add(measurement)) takeTurn(*points);
  }
}

void RplidarScanner::takeTurn(const std::vector<RangePoint>& points) {
  const double now_s = clock_();
  // It has no clock: measured in the middle of the turn that ends now.
  const double turn_s = last_turn_s_ > 0.0 ? std::min(now_s - last_turn_s_, 0.5) : 0.1;
  last_turn_s_ = now_s;
  port_.delivers();
  tell(DeviceState::Ready, model_);
  Q_EMIT scanned(now_s - 0.5 * turn_s, points);
}

void RplidarScanner::watch() {
  const double waited_s = clock_() - step_since_s_;
  if (step_ == Step::Stopping) {
    if (waited_s > kQuiet_s) go(Step::Identifying);
  } else if (step_ == Step::Resetting) {
    if (waited_s > kReset_s) go(++attempts_ < kMostAttempts ? Step::Stopping : Step::Closed);
    if (step_ == Step::Closed) port_.giveUp(QStringLiteral("the scanner reports an error"));
  } else if (step_ == Step::Scanning) {
    const bool began = last_turn_s_ > 0.0;
    const double silent_s = began ? clock_() - last_turn_s_ : waited_s;
    if (silent_s > (began ? kSilence_s : kSpinUp_s)) {
      port_.giveUp(QStringLiteral("the scanner sends no whole turn: does its motor run?"));
    }
  } else if (step_ == Step::StartingExpress && waited_s > kPatience_s) {
    go(Step::StartingPlain);  // older firmwares know no other
  } else if (waited_s > kPatience_s) {
    if (++attempts_ < kMostAttempts) return go(Step::Stopping);
    port_.giveUp(QStringLiteral("what is at this port does not answer as an RPLIDAR"));
  }
}

void RplidarScanner::tell(DeviceState state, const QString& detail) {
  if (told_.changes(state, detail)) Q_EMIT stateChanged(state, detail);
}

}  // namespace handmap
