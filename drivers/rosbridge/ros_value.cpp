#include "drivers/rosbridge/ros_value.h"

#include <QCborArray>
#include <QCborMap>
#include <QtEndian>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

// RFC 8746: a tag of 64 and more is 0b010 f s e ll: floating point, signed, little-endian, size.
constexpr unsigned kFirstTyped = 64;
constexpr unsigned kLastTyped = 86;
constexpr unsigned kFloat = 16;
constexpr unsigned kSigned = 8;
constexpr unsigned kLittle = 4;

template <typename Number>
double read(const char* at, bool little) {
  return static_cast<double>(little ? qFromLittleEndian<Number>(at) : qFromBigEndian<Number>(at));
}

std::string shown(const QCborValue& value) {
  if (value.isUndefined() || value.isInvalid()) return "nothing";
  if (value.isNull()) return "null";
  if (value.isMap()) return phrase("an object");
  if (value.isArray()) return phrase("a list");
  if (value.isString()) return fmt::format("\"{}\"", value.toString().left(40).toStdString());
  if (value.isInteger()) return fmt::format("{}", value.toInteger());
  if (value.isDouble()) return fmt::format("{:g}", value.toDouble());
  return phrase("another kind of value");
}

}  // namespace

// Nobody sends half and quadruple precision.
std::size_t typedSize(unsigned tag) {
  const unsigned size = tag & 3U;
  if ((tag & kFloat) == 0) return std::size_t{1} << size;
  return size == 1 || size == 2 ? std::size_t{2} << size : 0;
}

double typedNumber(unsigned tag, const char* at) {
  const bool little = (tag & kLittle) != 0;
  if ((tag & kFloat) != 0) {
    return typedSize(tag) == 4 ? read<float>(at, little) : read<double>(at, little);
  }
  const bool is_signed = (tag & kSigned) != 0;
  switch (tag & 3U) {
    case 0:
      return is_signed ? read<qint8>(at, little) : read<quint8>(at, little);
    case 1:
      return is_signed ? read<qint16>(at, little) : read<quint16>(at, little);
    case 2:
      return is_signed ? read<qint32>(at, little) : read<quint32>(at, little);
    default:
      return is_signed ? read<qint64>(at, little) : read<quint64>(at, little);
  }
}

void RosValue::fail(const std::string& found, const std::string& expected) const {
  throwBadInput(topic_, path_, found, expected);
}

void RosValue::failKind(const std::string& expected) const { fail(shown(value_), expected); }

std::optional<RosValue> RosValue::find(const char* key) const {
  if (!value_.isMap()) failKind(phrase("an object"));
  const QCborValue member = value_[QLatin1String(key)];
  if (member.isUndefined()) return std::nullopt;
  return RosValue(member, topic_, path_.empty() ? key : path_ + '.' + key);
}

RosValue RosValue::at(const char* key) const {
  const auto member = find(key);
  if (!member) fail(phrase("no {}", key), phrase("the member {}", key));
  return *member;
}

std::vector<RosValue> RosValue::items(std::size_t most) const {
  if (!value_.isArray()) failKind(phrase("a list"));
  const QCborArray array = value_.toArray();
  const auto count = static_cast<std::size_t>(array.size());
  if (count > most) fail(phrase("{} values", count), phrase("at most {}", most));
  std::vector<RosValue> items;
  items.reserve(count);
  for (qsizetype i = 0; i < array.size(); ++i) {
    items.push_back(RosValue(array[i], topic_, fmt::format("{}[{}]", path_, i)));
  }
  return items;
}

double RosValue::number(double low, double high) const {
  if (!value_.isDouble() && !value_.isInteger()) failKind(phrase("a number"));
  const double number = value_.toDouble();
  if (!(number >= low && number <= high)) {
    fail(fmt::format("{:g}", number), phrase("a number from {:g} to {:g}", low, high));
  }
  return number;
}

std::int64_t RosValue::integer(std::int64_t low, std::int64_t high) const {
  const double value = number(static_cast<double>(low), static_cast<double>(high));
  if (value != std::floor(value)) fail(fmt::format("{:g}", value), phrase("a whole number"));
  return static_cast<std::int64_t>(value);
}

bool RosValue::flag() const {
  // ROS 1 sends its booleans as numbers here and there.
  if (value_.isInteger()) return integer(0, 1) == 1;
  if (!value_.isBool()) failKind(phrase("true or false"));
  return value_.toBool();
}

std::string RosValue::text(std::size_t most_bytes) const {
  if (!value_.isString()) failKind(phrase("a text"));
  std::string text = value_.toString().toStdString();
  if (text.size() > most_bytes) {
    fail(phrase("a text of {} bytes", text.size()), phrase("at most {}", most_bytes));
  }
  return text;
}

QByteArray RosValue::bytes(std::size_t most) const {
  QByteArray bytes;
  if (value_.isString()) {
    const auto decoded = QByteArray::fromBase64Encoding(value_.toString().toLatin1(),
                                                        QByteArray::AbortOnBase64DecodingErrors);
    if (!decoded) fail(phrase("a text"), "base64");
    bytes = *decoded;
  } else if (value_.isByteArray()) {
    bytes = value_.toByteArray();
  } else if (value_.isTag() && static_cast<quint64>(value_.tag()) == kFirstTyped &&
             value_.taggedValue().isByteArray()) {
    bytes = value_.taggedValue().toByteArray();
  } else {
    for (const double number : numbers(most)) {
      if (!(number >= 0.0 && number <= 255.0)) fail(fmt::format("{:g}", number), phrase("bytes"));
      bytes += static_cast<char>(static_cast<unsigned char>(number));
    }
  }
  if (static_cast<std::size_t>(bytes.size()) > most) {
    fail(phrase("{} bytes", bytes.size()), phrase("at most {}", most));
  }
  return bytes;
}

std::vector<double> RosValue::numbers(std::size_t most) const {
  if (value_.isTag()) return typedArray(most);
  if (!value_.isArray()) failKind(phrase("a list of numbers"));
  const QCborArray array = value_.toArray();
  const auto count = static_cast<std::size_t>(array.size());
  if (count > most) fail(phrase("{} values", count), phrase("at most {}", most));
  std::vector<double> numbers;
  numbers.reserve(count);
  for (const auto& value : array) {
    if (!value.isDouble() && !value.isInteger() && !value.isNull()) {
      failKind(phrase("numbers alone"));
    }
    numbers.push_back(value.toDouble(std::numeric_limits<double>::quiet_NaN()));
  }
  return numbers;
}

std::vector<double> RosValue::typedArray(std::size_t most) const {
  const auto tag = static_cast<quint64>(value_.tag());
  const QByteArray bytes = value_.taggedValue().toByteArray();
  if (tag < kFirstTyped || tag > kLastTyped || !value_.taggedValue().isByteArray()) {
    failKind(phrase("a list of numbers"));
  }
  const auto kind = static_cast<unsigned>(tag);
  const std::size_t size = typedSize(kind);
  if (size == 0 || static_cast<std::size_t>(bytes.size()) % size != 0) {
    failKind(phrase("a list of numbers of 8 to 64 bits"));
  }
  const std::size_t count = static_cast<std::size_t>(bytes.size()) / size;
  if (count > most) fail(phrase("{} values", count), phrase("at most {}", most));
  std::vector<double> numbers;
  numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    numbers.push_back(typedNumber(kind, bytes.data() + i * size));
  return numbers;
}

}  // namespace handmap
