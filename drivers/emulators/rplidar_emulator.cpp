#include "drivers/emulators/rplidar_emulator.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handmap {

namespace {

using rplidar::Answer;
using rplidar::Request;

constexpr int kTurnTick_ms = 5;
constexpr double kTurnsASecond = 10.0;
constexpr int kPerTurn = 720;
constexpr double kMostAtOnce = 400.0;
constexpr double kStep_rad = 2.0 * kPi / kPerTurn;

std::string descriptor(Answer answer, bool many) {
  const std::size_t size = rplidar::sizeOf(answer);
  return {'\xA5',
          '\x5A',
          static_cast<char>(size),
          0,
          0,
          static_cast<char>(many ? 0x40 : 0),
          static_cast<char>(answer)};
}

void put(std::string& bytes, unsigned word) {
  bytes += static_cast<char>(word & 0xffU);
  bytes += static_cast<char>(word >> 8U & 0xffU);
}

}  // namespace

RplidarEmulator::RplidarEmulator(EmulatedPort::Kind kind, RangeFunction range, Express express,
                                 std::uint64_t seed)
    : port_(kind, seed), range_(std::move(range)), express_(express) {
  connect(&port_, &EmulatedPort::received, this, &RplidarEmulator::hear);
  connect(&port_, &EmulatedPort::unplugged, &timer_, &QTimer::stop);
  connect(&timer_, &QTimer::timeout, this, &RplidarEmulator::measure);
}

// A request is A5, its code and, for the codes above 7F, a length, so many bytes and a checksum.
void RplidarEmulator::hear(const QByteArray& bytes) {
  if (dead_) return;
  heard_.append(bytes.constData(), static_cast<std::size_t>(bytes.size()));
  for (;;) {
    const std::size_t begin = heard_.find('\xA5');
    heard_.erase(0, begin == std::string::npos ? heard_.size() : begin);
    if (heard_.size() < 2) return;
    const auto code = static_cast<std::uint8_t>(heard_[1]);
    std::size_t size = 2;
    if (code >= 0x80U) {
      if (heard_.size() < 3) return;
      size += static_cast<std::uint8_t>(heard_[2]) + std::size_t{2};
    }
    if (heard_.size() < size) return;
    heard_.erase(0, size);
    obey(static_cast<Request>(code));
  }
}

void RplidarEmulator::obey(Request request) {
  switch (request) {
    case Request::Stop:
      return timer_.stop();
    case Request::Reset:
      timer_.stop();
      health_ = 0;
      ++resets_;
      return port_.write("RP LIDAR System.\r\nFirmware Ver 1.29\r\n");
    case Request::GetInfo:
      return port_.write(descriptor(Answer::Info, false) + '\x18' + std::string(19, '\1'));
    case Request::GetHealth:
      return port_.write(descriptor(Answer::Health, false) + static_cast<char>(health_) +
                         std::string(2, '\0'));
    case Request::Scan:
      return begin(Answer::Node);
    case Request::ExpressScan:
      if (express_ == Express::None) return;
      return begin(express_ == Express::Dense ? Answer::Dense : Answer::Capsule);
    default:
      return;
  }
}

void RplidarEmulator::begin(Answer answer) {
  sending_ = answer;
  port_.write(descriptor(answer, true));
  angle_rad_ = 0.3;  // nobody knows where the motor stood
  first_capsule_ = true;
  due_ = 0.0;
  clock_.start();
  timer_.start(kTurnTick_ms);
}

void RplidarEmulator::measure() {
  if (dead_) return;
  due_ += static_cast<double>(clock_.restart()) * 1e-3 * kTurnsASecond * kPerTurn;
  due_ = std::min(due_, kMostAtOnce);  // what it could not send in time is gone
  const int size = sending_ == Answer::Node ? 1 : sending_ == Answer::Dense ? 40 : 32;
  for (; due_ >= size; due_ -= size) {
    if (sending_ != Answer::Node) {
      sendCapsule();
      continue;
    }
    const double next = angle_rad_ + kStep_rad;
    sendNode(angle_rad_, next >= 2.0 * kPi);
    angle_rad_ = std::fmod(next, 2.0 * kPi);
  }
}

unsigned RplidarEmulator::rangeAt(double clockwise_rad, double units_a_metre, unsigned most) const {
  const double units = range_(-clockwise_rad) * units_a_metre;
  return units >= 0.0 && units <= most ? static_cast<unsigned>(std::lround(units)) : 0U;
}

// The mark is on the last measurement of a turn here: marks and angles need not agree to the step.
void RplidarEmulator::sendNode(double clockwise_rad, bool begins) {
  const auto angle_q6 = static_cast<unsigned>(toDegrees(clockwise_rad) * 64.0);
  std::string bytes;
  bytes += static_cast<char>(15U << 2U | (begins ? 1U : 2U));
  put(bytes, angle_q6 << 1U | 1U);
  put(bytes, rangeAt(clockwise_rad, 4000.0, 0xffff));
  port_.write(bytes);
}

void RplidarEmulator::sendCapsule() {
  const bool dense = sending_ == Answer::Dense;
  std::string body;
  const auto start_q6 = static_cast<unsigned>(toDegrees(angle_rad_) * 64.0);
  put(body, start_q6 | (std::exchange(first_capsule_, false) ? 0x8000U : 0U));
  for (int i = 0; i < (dense ? 40 : 16); ++i) {
    const double angle = angle_rad_ + kStep_rad * i;
    if (dense) {
      put(body, rangeAt(angle, 1000.0, 0xffff));
      continue;
    }
    // Each measurement of a pair a degree and a half behind and before its place, as told.
    constexpr unsigned kEighths = 12;
    const double shift = toRadians(kEighths / 8.0);
    const double first = angle_rad_ + kStep_rad * (2 * i) - shift;
    const double second = angle_rad_ + kStep_rad * (2 * i + 1) + shift;
    const unsigned second_bits = kEighths | 0x20U;
    put(body, rangeAt(first, 1000.0, 0x3fff) << 2U | kEighths >> 4U);
    put(body, rangeAt(second, 1000.0, 0x3fff) << 2U | second_bits >> 4U);
    body += static_cast<char>((second_bits & 0xfU) << 4U | kEighths);
  }
  unsigned sum = 0;
  for (const char byte : body) sum ^= static_cast<std::uint8_t>(byte);
  port_.write(
      std::string{static_cast<char>(0xA0U | (sum & 0xfU)), static_cast<char>(0x50U | sum >> 4U)} +
      body);
  angle_rad_ = std::fmod(angle_rad_ + kStep_rad * (dense ? 40 : 32), 2.0 * kPi);
}

}  // namespace handmap
