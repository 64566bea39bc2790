// The serial protocol of SLAMTEC's RPLIDAR A and S series, without any port: bytes in, answers and
// measurements out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/recording/observation.h"

namespace handmap {

namespace rplidar {

enum class Request : std::uint8_t {
  Stop = 0x25,
  Reset = 0x40,
  Scan = 0x20,
  ExpressScan = 0x82,
  GetInfo = 0x50,
  GetHealth = 0x52,
  MotorPwm = 0xF0,    ///< A2, A3
  MotorSpeed = 0xA8,  ///< S series
};
/// With its payload, length and checksum where there is a payload.
std::string request(Request code, std::string_view payload = {});

/// What an answer is, by the last byte of its descriptor.
enum class Answer : std::uint8_t {
  Info = 0x04,
  Health = 0x06,
  Node = 0x81,     ///< one measurement
  Capsule = 0x82,  ///< 32 of them, angles within a third of a degree told
  Dense = 0x85,    ///< 40 of them, evenly spread
};
/// Bytes of an answer.
std::size_t sizeOf(Answer answer);

struct Descriptor {
  Answer answer;
  bool many = false;  ///< the answer comes again and again
};

/// Clockwise seen from above, as the scanner counts.
struct Measurement {
  double angle_rad = 0.0;
  double range_m = 0.0;  ///< 0: nothing
  bool begins_turn = false;
};

/// nullopt where the check bits are wrong.
std::optional<Measurement> parseNode(std::span<const std::uint8_t, 5> bytes);

/// A capsule tells its first angle alone, so that it is understood when the next one is there.
struct Capsule {
  double first_angle_rad = 0.0;
  bool begins_scan = false;  ///< the first since the scanner was asked
  std::array<std::uint8_t, 80> data{};
};
/// Both kinds; nullopt where the sync bits or the checksum are wrong.
std::optional<Capsule> parseCapsule(std::span<const std::uint8_t, 84> bytes);
std::vector<Measurement> expand(const Capsule& capsule, const Capsule& next, Answer kind);

}  // namespace rplidar

/// Finds descriptors and answers in the bytes. After a damaged answer it looks for the next place
/// where one may begin.
class RplidarReader {
 public:
  struct Events {
    std::optional<rplidar::Answer> began;  ///< the last descriptor
    std::optional<std::string> info;       ///< 20 bytes: model, firmware, hardware, serial number
    std::optional<std::uint8_t> health;    ///< 0 well, 1 warning, 2 error
    std::vector<rplidar::Measurement> measurements;
  };
  Events feed(std::string_view bytes);
  void clear();
  int damaged() const { return damaged_; }

 private:
  bool readDescriptor(Events& events);
  bool readAnswer(Events& events);
  bool readMeasurements(std::size_t size, Events& events);
  std::string_view rest() const { return std::string_view(buffer_).substr(begin_); }

  std::string buffer_;
  std::size_t begin_ = 0;  ///< of what is not yet read
  std::optional<rplidar::Descriptor> open_;
  std::optional<rplidar::Capsule> capsule_;
  int damaged_ = 0;
};

/// Whole turns out of measurements.
class RplidarTurns {
 public:
  /// The points of the turn that `next` has ended: x forward, y left, z = 0, w = 1.
  std::optional<std::vector<RangePoint>> add(const rplidar::Measurement& next);
  void clear();

 private:
  std::vector<RangePoint> points_;
  int measurements_ = 0;
  double last_angle_rad_ = 0.0;
  bool whole_ = false;  ///< the turn was seen from its beginning
};

}  // namespace handmap
