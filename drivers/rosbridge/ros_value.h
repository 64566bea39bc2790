// One value of a ROS message as a bridge sent it, read with messages that name its path.
#pragma once

#include <QByteArray>
#include <QCborValue>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace handmap {

/// Of an element of a typed array (RFC 8746): its bytes (0: a kind that nobody sends), its number.
std::size_t typedSize(unsigned tag);
double typedNumber(unsigned tag, const char* at);

/// Whatever reads it throws BadInput "/odom: pose.pose.position.x: found …, expected …".
class RosValue {
 public:
  /// `topic` names the message.
  RosValue(QCborValue value, std::string topic)
      : RosValue(std::move(value), std::move(topic), {}) {}

  RosValue at(const char* key) const;  ///< throws where it is missing
  std::optional<RosValue> find(const char* key) const;
  std::vector<RosValue> items(std::size_t most) const;

  double number(double low, double high) const;
  std::int64_t integer(std::int64_t low, std::int64_t high) const;
  bool flag() const;
  std::string text(std::size_t most_bytes) const;
  /// Of uint8[]: base64 (JSON), a byte string (CBOR), or a list of numbers.
  QByteArray bytes(std::size_t most) const;
  /// Of float32[] and the like: a list (null: not a number) or a typed array of RFC 8746.
  std::vector<double> numbers(std::size_t most) const;

  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

 private:
  RosValue(QCborValue value, std::string topic, std::string path)
      : value_(std::move(value)), topic_(std::move(topic)), path_(std::move(path)) {}
  [[noreturn]] void failKind(const std::string& expected) const;
  std::vector<double> typedArray(std::size_t most) const;

  QCborValue value_;
  std::string topic_;
  std::string path_;
};

}  // namespace handmap
