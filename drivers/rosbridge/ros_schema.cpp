#include "drivers/rosbridge/ros_schema.h"

#include <QCborArray>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/bags/field_reader.h"
#include "core/bags/field_writer.h"
#include "core/bags/ros_definitions.h"
#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "drivers/rosbridge/bounded_message.h"

namespace handmap {

namespace {

constexpr std::size_t kMostDefinition = 1 << 20;
constexpr std::size_t kMostTypes = 1000;
constexpr std::size_t kMostFields = 1000;
constexpr std::size_t kMostFixed = 100'000;
constexpr std::size_t kMostText = 1 << 20;

struct Primitive {
  std::string_view name;
  unsigned tag;  ///< of a little-endian typed array
};
constexpr unsigned kBytes = 64;
constexpr std::array kPrimitives = {
    Primitive{"byte", kBytes}, Primitive{"char", kBytes}, Primitive{"uint8", kBytes},
    Primitive{"int8", 72},     Primitive{"uint16", 69},   Primitive{"int16", 77},
    Primitive{"uint32", 70},   Primitive{"int32", 78},    Primitive{"uint64", 71},
    Primitive{"int64", 79},    Primitive{"float32", 85},  Primitive{"float64", 86}};
constexpr unsigned kFirstReal = 80;
constexpr double kMostWhole = 9e18;  // of what 64 bits with a sign hold

std::string_view uncommented(std::string_view line) { return line.substr(0, line.find('#')); }

}  // namespace

/// Takes the text apart into the types that it tells, then goes from the first into those within.
class RosSchema::Parser {
 public:
  Parser(RosSchema& schema, std::string_view definition) : schema_(schema) {
    if (definition.size() > kMostDefinition) {
      refuse(phrase("{} bytes", definition.size()), phrase("at most {}", kMostDefinition));
    }
    std::string at = schema_.type_;
    texts_[at];
    ContentLines lines(definition);
    while (const auto line = lines.next()) {
      const auto words = splitWords(uncommented(line->text));
      if (words.empty() || words[0].starts_with("====")) continue;
      if (words[0] == "MSG:" && words.size() > 1) {
        at = rosTypeName(std::string(words[1]));
        texts_[at];
        if (texts_.size() > kMostTypes)
          refuse(phrase("too many types"), phrase("at most {}", kMostTypes));
      } else {
        texts_[at].push_back(words);
      }
    }
    add(schema_.type_, 0);
  }

 private:
  using Lines = std::vector<std::vector<std::string_view>>;

  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throwBadInput(schema_.type_, "", found, expected);
  }

  std::size_t add(const std::string& type, int depth) {
    if (depth > MessageLimits{}.depth) {
      refuse(phrase("more than {} levels of nesting", MessageLimits{}.depth), phrase("fewer"));
    }
    for (std::size_t i = 0; i < done_.size(); ++i) {
      if (done_[i] && schema_.messages_[i].type == type) return i;
    }
    const std::size_t index = schema_.messages_.size();
    schema_.messages_.push_back({type, {}});
    done_.push_back(false);
    std::vector<Field> fields;
    for (const auto& words : texts_.at(type)) {
      if (auto field = fieldOf(words, type, depth)) fields.push_back(std::move(*field));
      if (fields.size() > kMostFields)
        refuse(phrase("too many fields"), phrase("at most {}", kMostFields));
    }
    schema_.messages_[index].fields = std::move(fields);
    done_[index] = true;
    return index;
  }

  /// nullopt: a constant.
  std::optional<Field> fieldOf(const std::vector<std::string_view>& words,
                               const std::string& within, int depth) {
    if (words.size() < 2) refuse('"' + std::string(words[0]) + '"', phrase("a type and a name"));
    const bool is_constant = words[1].find('=') != std::string_view::npos ||
                             (words.size() > 2 && words[2].starts_with('='));
    if (is_constant) return std::nullopt;
    Field field;
    field.key = QString::fromUtf8(words[1].data(), static_cast<qsizetype>(words[1].size()));
    std::string_view name = words[0];
    if (const std::size_t at = name.find('['); at != std::string_view::npos) {
      readCount(name.substr(at), field);
      name = name.substr(0, at);
    }
    name = name.substr(0, name.find("<="));  // of texts that are bounded
    const auto primitive = std::ranges::find(kPrimitives, name, &Primitive::name);
    if (primitive != kPrimitives.end()) {
      field.tag = primitive->tag;
    } else if (name == "bool") {
      field.kind = Kind::Truth;
    } else if (name == "string") {
      field.kind = Kind::Text;
    } else if (name == "time" || name == "duration") {
      field.kind = Kind::Time;
    } else {
      field.kind = Kind::Message;
      field.message = add(resolved(std::string(name), within), depth + 1);
    }
    return field;
  }

  /// "[]", "[<=5]", "[36]"
  void readCount(std::string_view brackets, Field& field) const {
    if (!brackets.ends_with(']')) refuse('"' + std::string(brackets) + '"', "]");
    const std::string_view inner = brackets.substr(1, brackets.size() - 2);
    field.many = inner.empty() || inner.starts_with("<=") ? Many::Any : Many::Fixed;
    if (field.many == Many::Any) return;
    field.count = 0;
    for (const char digit : inner) {
      if (digit < '0' || digit > '9' || field.count > kMostFixed) {
        refuse('"' + std::string(brackets) + '"', phrase("at most {}", kMostFixed));
      }
      field.count = field.count * 10 + static_cast<std::size_t>(digit - '0');
    }
  }

  /// Of the same package where none is named; ROS 1 knows "Header" alone.
  std::string resolved(const std::string& name, const std::string& within) {
    std::string plain = rosTypeName(name);
    const std::string near = within.substr(0, within.find('/') + 1) + plain;
    for (const std::string& type : {plain, near, "std_msgs/" + plain}) {
      if (texts_.contains(type)) return type;
    }
    if (plain == "builtin_interfaces/Time" || plain == "builtin_interfaces/Duration") {
      texts_[plain] = {{"int32", "sec"}, {"uint32", "nanosec"}};  // not everybody spells it out
      return plain;
    }
    refuse('"' + name + '"', phrase("a type that is told"));
  }

  RosSchema& schema_;
  std::map<std::string, Lines> texts_;
  std::vector<bool> done_;  ///< of schema_.messages_: one that is met before holds itself
};

class RosSchema::Reading {
 public:
  Reading(const RosSchema& schema, FieldReader fields)
      : schema_(schema), fields_(std::move(fields)) {}

  QCborMap message(std::size_t index) {
    const Message& message = schema_.messages_[index];
    QCborMap map;
    for (const Field& field : message.fields) map.insert(field.key, value(field));
    // One that is empty has a byte in CDR.
    const bool has_byte = schema_.encoding_ == MessageEncoding::Cdr && message.fields.empty();
    if (has_byte && fields_.left() > 0) fields_.take(1);
    return map;
  }

 private:
  QCborValue value(const Field& field) {
    if (field.many == Many::One) return one(field);
    const bool is_number = field.kind == Kind::Number || field.kind == Kind::Truth;
    const std::size_t size = field.kind == Kind::Number ? typedSize(field.tag) : 1;
    const std::size_t count = field.many == Many::Any ? fields_.count(size) : field.count;
    if (is_number) {
      const unsigned tag = field.kind == Kind::Truth ? kBytes : field.tag;
      const std::string raw = fields_.numbers(count, size);
      const QByteArray bytes(raw.data(), static_cast<qsizetype>(raw.size()));
      return tag == kBytes ? QCborValue(bytes) : QCborValue(static_cast<QCborTag>(tag), bytes);
    }
    QCborArray list;
    for (std::size_t i = 0; i < count; ++i) list.append(one(field));
    return list;
  }

  QCborValue one(const Field& field) {
    if (++values_ > MessageLimits{}.values) {
      fields_.fail(phrase("more than {} values", MessageLimits{}.values), phrase("fewer"));
    }
    switch (field.kind) {
      case Kind::Number:
        return number(field.tag);
      case Kind::Truth:
        return fields_.get<std::uint8_t>() != 0;
      case Kind::Text:
        return QString::fromStdString(fields_.text(kMostText));
      case Kind::Time: {
        const qint64 seconds = fields_.get<std::uint32_t>();
        const qint64 nanoseconds = fields_.get<std::uint32_t>();
        return QCborMap{{QLatin1String("secs"), seconds}, {QLatin1String("nsecs"), nanoseconds}};
      }
      case Kind::Message:
        break;
    }
    return message(field.message);
  }

  QCborValue number(unsigned tag) {
    const double number = typedNumber(tag, fields_.numbers(1, typedSize(tag)).data());
    const bool is_whole = tag < kFirstReal && std::abs(number) < kMostWhole;
    return is_whole ? QCborValue(static_cast<qint64>(number)) : QCborValue(number);
  }

  const RosSchema& schema_;
  FieldReader fields_;
  int values_ = 0;
};

class RosSchema::Writing {
 public:
  explicit Writing(const RosSchema& schema) : schema_(schema) {}

  std::string written(const RosValue& value) {
    message(0, value);
    return out_.bytes();
  }

 private:
  void message(std::size_t index, const std::optional<RosValue>& value) {
    const Message& message = schema_.messages_[index];
    for (const Field& field : message.fields) {
      const std::string key = field.key.toStdString();
      const auto member = value ? value->find(key.c_str()) : std::nullopt;
      put(field, member);
    }
    if (message.fields.empty()) out_.put(std::uint8_t{0});
  }

  void put(const Field& field, const std::optional<RosValue>& value) {
    if (field.many == Many::One) return one(field, value);
    const bool is_number = field.kind == Kind::Number || field.kind == Kind::Truth;
    if (is_number && field.tag == kBytes && field.many == Many::Any) {
      const QByteArray bytes = value ? value->bytes(kMostBytes) : QByteArray();
      return out_.sized<std::uint32_t>({bytes.data(), static_cast<std::size_t>(bytes.size())});
    }
    if (is_number) {
      std::vector<double> numbers = value ? value->numbers(kMostBytes) : std::vector<double>();
      if (field.many == Many::Any) out_.count(numbers.size());
      if (field.many == Many::Fixed) numbers.resize(field.count);
      for (const double number : numbers) this->number(field.tag, number);
      return;
    }
    std::vector<RosValue> items = value ? value->items(kMostBytes) : std::vector<RosValue>();
    if (field.many == Many::Any) out_.count(items.size());
    const std::size_t count = field.many == Many::Any ? items.size() : field.count;
    for (std::size_t i = 0; i < count; ++i) {
      one(field, i < items.size() ? std::optional(items[i]) : std::nullopt);
    }
  }

  void one(const Field& field, const std::optional<RosValue>& value) {
    switch (field.kind) {
      case Kind::Number:
        return number(field.tag, value ? value->number(-1e300, 1e300) : 0.0);
      case Kind::Truth:
        return out_.put(static_cast<std::uint8_t>(value && value->flag() ? 1 : 0));
      case Kind::Text:
        return out_.text(value ? value->text(kMostText) : std::string());
      case Kind::Time:
        break;  // of ROS 1
      case Kind::Message:
        return message(field.message, value);
    }
  }

  template <typename Whole>
  void whole(double number) {
    using Limits = std::numeric_limits<Whole>;
    const double most = std::nextafter(std::ldexp(1.0, Limits::digits), 0.0);
    const double clamped = std::clamp(number, static_cast<double>(Limits::lowest()), most);
    out_.put(static_cast<Whole>(std::isnan(number) ? 0.0 : clamped));
  }

  void number(unsigned tag, double number) {
    switch (tag) {
      case kBytes:
        return whole<std::uint8_t>(number);
      case 72:
        return whole<std::int8_t>(number);
      case 69:
        return whole<std::uint16_t>(number);
      case 77:
        return whole<std::int16_t>(number);
      case 70:
        return whole<std::uint32_t>(number);
      case 78:
        return whole<std::int32_t>(number);
      case 71:
        return whole<std::uint64_t>(number);
      case 79:
        return whole<std::int64_t>(number);
      case 85:
        return out_.put(static_cast<float>(number));
      default:
        return out_.put(number);
    }
  }

  static constexpr std::size_t kMostBytes = 32 << 20;
  const RosSchema& schema_;
  FieldWriter out_ = FieldWriter::cdr();
};

RosSchema::RosSchema(std::string type, std::string_view definition, MessageEncoding encoding)
    : type_(rosTypeName(std::move(type))), encoding_(encoding) {
  Parser(*this, definition);
}

RosSchema RosSchema::known(const std::string& type) {
  return {type, rosDefinition(type), MessageEncoding::Cdr};
}

QCborMap RosSchema::read(std::string_view bytes, const std::string& topic) const {
  const bool is_cdr = encoding_ == MessageEncoding::Cdr;
  return Reading(*this, is_cdr ? FieldReader::cdr(bytes, topic) : FieldReader(bytes, topic))
      .message(0);
}

std::string RosSchema::write(const RosValue& message) const {
  return Writing(*this).written(message);
}

}  // namespace handmap
