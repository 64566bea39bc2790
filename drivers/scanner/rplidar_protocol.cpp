#include "drivers/scanner/rplidar_protocol.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handmap {

namespace rplidar {

namespace {

constexpr double kQ6_rad = toRadians(1.0 / 64.0);
constexpr double kQ3_rad = toRadians(1.0 / 8.0);
constexpr double kFullTurn = 2.0 * kPi;
constexpr double kQuarterMillimetre = 0.25e-3;
constexpr std::size_t kPairs = 16;
constexpr std::size_t kDense = 40;

unsigned wordAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  return bytes[at] | static_cast<unsigned>(bytes[at + 1]) << 8U;
}

double wrapped(double angle_rad) {
  const double rest = std::fmod(angle_rad, kFullTurn);
  return rest < 0.0 ? rest + kFullTurn : rest;
}

/// Six bits: a sign and eighths of a degree.
double correction(unsigned bits) {
  const double size = (bits & 0x1fU) * kQ3_rad;
  return (bits & 0x20U) != 0 ? -size : size;
}

}  // namespace

std::string request(Request code, std::string_view payload) {
  std::string bytes{'\xA5', static_cast<char>(code)};
  if (payload.empty()) return bytes;
  bytes += static_cast<char>(payload.size());
  bytes += payload;
  char sum = 0;
  for (const char byte : bytes) sum = static_cast<char>(sum ^ byte);
  return bytes + sum;
}

std::size_t sizeOf(Answer answer) {
  switch (answer) {
    case Answer::Info:
      return 20;
    case Answer::Health:
      return 3;
    case Answer::Node:
      return 5;
    case Answer::Capsule:
    case Answer::Dense:
      return 84;
  }
  return 0;
}

std::optional<Measurement> parseNode(std::span<const std::uint8_t, 5> bytes) {
  const bool begins = (bytes[0] & 1U) != 0;
  const bool not_begins = (bytes[0] & 2U) != 0;
  if (begins == not_begins || (bytes[1] & 1U) == 0) return std::nullopt;
  const double angle = (wordAt(bytes, 1) >> 1U) * kQ6_rad;
  if (angle >= kFullTurn + toRadians(5.0)) return std::nullopt;  // it may run a little over a turn
  return Measurement{wrapped(angle), wordAt(bytes, 3) * kQuarterMillimetre, begins};
}

std::optional<Capsule> parseCapsule(std::span<const std::uint8_t, 84> bytes) {
  if (bytes[0] >> 4U != 0xA || bytes[1] >> 4U != 0x5) return std::nullopt;
  unsigned sum = 0;
  for (const std::uint8_t byte : bytes.subspan(2)) sum ^= byte;
  if (sum != ((bytes[0] & 0xfU) | (bytes[1] & 0xfU) << 4U)) return std::nullopt;
  Capsule capsule;
  const unsigned start = wordAt(bytes, 2);
  capsule.first_angle_rad = (start & 0x7fffU) * kQ6_rad;
  capsule.begins_scan = (start & 0x8000U) != 0;
  if (capsule.first_angle_rad >= kFullTurn) return std::nullopt;
  std::copy(bytes.begin() + 4, bytes.end(), capsule.data.begin());
  return capsule;
}

std::vector<Measurement> expand(const Capsule& capsule, const Capsule& next, Answer kind) {
  const double turned = wrapped(next.first_angle_rad - capsule.first_angle_rad);
  std::vector<Measurement> measurements;
  double last = capsule.first_angle_rad;
  const auto add = [&](double nominal, double angle, double range_m) {
    const bool begins = std::floor(nominal / kFullTurn) > std::floor(last / kFullTurn);
    measurements.push_back({wrapped(angle), range_m, begins});
    last = nominal;
  };
  if (kind == Answer::Dense) {
    for (std::size_t i = 0; i < kDense; ++i) {
      const double angle = capsule.first_angle_rad + turned * static_cast<double>(i) / kDense;
      add(angle, angle, wordAt(capsule.data, 2 * i) * 1e-3);
    }
    return measurements;
  }
  for (std::size_t i = 0; i < kPairs; ++i) {
    const std::uint8_t low = capsule.data[5 * i + 4];
    for (std::size_t k = 0; k < 2; ++k) {
      const unsigned word = wordAt(capsule.data, 5 * i + 2 * k);
      const unsigned bits = (word & 3U) << 4U | (k == 0 ? low & 0xfU : low >> 4U);
      const double share = static_cast<double>(2 * i + k) / (2 * kPairs);
      const double angle = capsule.first_angle_rad + turned * share;
      add(angle, angle - correction(bits), (word & ~3U) * kQuarterMillimetre);
    }
  }
  return measurements;
}

}  // namespace rplidar

namespace {

constexpr std::size_t kDescriptorSize = 7;
constexpr int kMostOfATurn = 50'000;
constexpr int kFewestOfATurn = 30;

std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::optional<rplidar::Descriptor> parseDescriptor(std::span<const std::uint8_t> bytes) {
  const std::uint32_t word = bytes[2] | static_cast<std::uint32_t>(bytes[3]) << 8U |
                             static_cast<std::uint32_t>(bytes[4]) << 16U |
                             static_cast<std::uint32_t>(bytes[5]) << 24U;
  const auto answer = static_cast<rplidar::Answer>(bytes[6]);
  const std::size_t size = rplidar::sizeOf(answer);
  if (size == 0 || (word & 0x3fffffffU) != size || word >> 30U > 1) return std::nullopt;
  const bool many = word >> 30U == 1;
  const bool comes_once = answer == rplidar::Answer::Info || answer == rplidar::Answer::Health;
  if (many && comes_once) return std::nullopt;
  return rplidar::Descriptor{answer, many};
}

}  // namespace

RplidarReader::Events RplidarReader::feed(std::string_view bytes) {
  Events events;
  buffer_ += bytes;
  while (open_ ? readAnswer(events) : readDescriptor(events)) {
  }
  buffer_.erase(0, std::exchange(begin_, 0));
  return events;
}

void RplidarReader::clear() {
  buffer_.clear();
  begin_ = 0;
  open_.reset();
  capsule_.reset();
}

bool RplidarReader::readDescriptor(Events& events) {
  const std::size_t found = buffer_.find("\xA5\x5A", begin_);
  const std::size_t half = buffer_.ends_with('\xA5') ? 1 : 0;
  begin_ = found == std::string::npos ? std::max(begin_, buffer_.size() - half) : found;
  if (rest().size() < kDescriptorSize) return false;
  open_ = parseDescriptor(bytesOf(rest()));
  capsule_.reset();
  if (open_) events.began = open_->answer;
  begin_ += open_ ? kDescriptorSize : 2;
  return true;
}

bool RplidarReader::readAnswer(Events& events) {
  const std::size_t size = rplidar::sizeOf(open_->answer);
  if (rest().size() < size) return false;
  if (open_->many) return readMeasurements(size, events);
  if (open_->answer == rplidar::Answer::Info) events.info = rest().substr(0, size);
  if (open_->answer == rplidar::Answer::Health) {
    events.health = static_cast<std::uint8_t>(rest()[0]);
  }
  begin_ += size;
  open_.reset();
  return true;
}

// A byte that was lost shifts all that follow: one byte on, until the check bits are right again.
bool RplidarReader::readMeasurements(std::size_t size, Events& events) {
  const auto bytes = bytesOf(rest());
  if (open_->answer == rplidar::Answer::Node) {
    const auto measurement = rplidar::parseNode(bytes.first<5>());
    if (measurement) events.measurements.push_back(*measurement);
    damaged_ += measurement ? 0 : 1;
    begin_ += measurement ? size : 1;
    return true;
  }
  const auto capsule = rplidar::parseCapsule(bytes.first<84>());
  if (!capsule) {
    damaged_ += capsule_ ? 1 : 0;
    capsule_.reset();
    ++begin_;
    return true;
  }
  if (capsule_ && !capsule->begins_scan) {
    const auto expanded = rplidar::expand(*capsule_, *capsule, open_->answer);
    events.measurements.insert(events.measurements.end(), expanded.begin(), expanded.end());
  }
  capsule_ = capsule;
  begin_ += size;
  return true;
}

std::optional<std::vector<RangePoint>> RplidarTurns::add(const rplidar::Measurement& next) {
  std::optional<std::vector<RangePoint>> turn;
  // Where the mark was lost, the angle that falls back tells as much; they need not come together.
  const bool begins = next.begins_turn || next.angle_rad < last_angle_rad_ - kPi;
  if (begins && (!whole_ || measurements_ >= kFewestOfATurn)) {
    if (whole_) turn = std::move(points_);
    clear();
    whole_ = true;
  }
  last_angle_rad_ = next.angle_rad;
  if (++measurements_ > kMostOfATurn) clear();
  if (next.range_m > 0.0) {
    const Vec2 point = next.range_m * unitVector(-next.angle_rad);
    points_.push_back({static_cast<float>(point.x()), static_cast<float>(point.y()), 0.0F, 1.0F});
  }
  return turn;
}

void RplidarTurns::clear() {
  points_.clear();
  measurements_ = 0;
  last_angle_rad_ = 0.0;
  whole_ = false;
}

}  // namespace handmap
