#include "drivers/scanner/rplidar_scanner.h"

#include <algorithm>
#include <utility>

#include "drivers/device/q_phrase.h"

namespace handmap {

namespace {

using rplidar::Answer;
using rplidar::Request;

constexpr int kRplidarWatch_ms = 50;
constexpr double kQuiet_s = 0.1;  // until what was still under way has come
constexpr double kReset_s = 2.5;  // it starts its own computer anew
constexpr double kRplidarPatience_s = 1.0;
constexpr double kSpinUp_s = 4.0;  // until the motor turns evenly
constexpr int kRplidarAttempts = 4;
constexpr std::uint8_t kHealthError = 2;

std::string littleEndian(unsigned value) {
  return {static_cast<char>(value & 0xffU), static_cast<char>(value >> 8U & 0xffU)};
}

}  // namespace

RplidarScanner::RplidarScanner(PortAddress address, RigClock clock, std::uint64_t seed,
                               QObject* parent)
    : PortDevice(std::move(address), std::move(clock), seed, kRplidarWatch_ms,
                 qPhrase("opening the port of the scanner"), parent) {}

RplidarScanner::~RplidarScanner() { close(); }

void RplidarScanner::begin() {
  attempts_ = 0;
  go(Step::Stopping);
}

void RplidarScanner::take(const QByteArray& bytes) {
  take(reader_.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())}));
}

void RplidarScanner::rest() {
  if (step_ == Step::Closed) return;
  port().write(rplidar::request(Request::Stop));
  motor(false);
}

// Each series has its own switch, and passes over those of the others.
void RplidarScanner::motor(bool on) {
  constexpr unsigned kPwm = 660;  // the maker's default, of 1023
  constexpr unsigned kTurnsAMinute = 600;
  port().setDataTerminalReady(!on);
  port().write(rplidar::request(Request::MotorPwm, littleEndian(on ? kPwm : 0)));
  port().write(rplidar::request(Request::MotorSpeed, littleEndian(on ? kTurnsAMinute : 0)));
}

void RplidarScanner::go(Step step) {
  step_ = step;
  step_since_s_ = now_s();
  switch (step) {
    case Step::Closed:
      return;
    case Step::Stopping:
      tell(DeviceState::Connecting, qPhrase("asking the scanner what it is"));
      return port().write(rplidar::request(Request::Stop));
    case Step::Identifying:
      reader_.clear();
      return port().write(rplidar::request(Request::GetInfo));
    case Step::Examining:
      return port().write(rplidar::request(Request::GetHealth));
    case Step::Resetting:
      tell(DeviceState::Degraded, qPhrase("the scanner reports an error and is reset"));
      return port().write(rplidar::request(Request::Reset));
    case Step::StartingExpress:
      motor(true);
      return port().write(rplidar::request(Request::ExpressScan, std::string(5, '\0')));
    case Step::StartingPlain:
      port().write(rplidar::request(Request::Stop));
      return port().write(rplidar::request(Request::Scan));
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
  const double end_s = now_s();
  // It has no clock: measured in the middle of the turn that ends now.
  const double turn_s = last_turn_s_ > 0.0 ? std::min(end_s - last_turn_s_, 0.5) : 0.1;
  last_turn_s_ = end_s;
  port().delivers();
  tell(DeviceState::Ready, model_);
  Q_EMIT scanned(end_s - 0.5 * turn_s, points);
}

void RplidarScanner::watch() {
  const double waited_s = now_s() - step_since_s_;
  if (step_ == Step::Stopping) {
    if (waited_s > kQuiet_s) go(Step::Identifying);
  } else if (step_ == Step::Resetting) {
    if (waited_s > kReset_s) go(++attempts_ < kRplidarAttempts ? Step::Stopping : Step::Closed);
    if (step_ == Step::Closed) port().giveUp(qPhrase("the scanner reports an error"));
  } else if (step_ == Step::Scanning) {
    const bool began = last_turn_s_ > 0.0;
    const double silent_s = began ? now_s() - last_turn_s_ : waited_s;
    if (silent_s > (began ? kSilence_s : kSpinUp_s)) {
      port().giveUp(qPhrase("the scanner sends no whole turn: does its motor run?"));
    }
  } else if (step_ == Step::StartingExpress && waited_s > kRplidarPatience_s) {
    go(Step::StartingPlain);  // older firmwares know no other
  } else if (waited_s > kRplidarPatience_s) {
    if (++attempts_ < kRplidarAttempts) return go(Step::Stopping);
    port().giveUp(qPhrase("what is at this port does not answer as an RPLIDAR"));
  }
}

}  // namespace handmap
