#include "core/base/json.h"

#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/spelling.h"
#include "core/base/text.h"

namespace handmap {

using nlohmann::json;

namespace {

constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxValues = 8'000'000;

/// Follows the parser to refuse what it would let pass: depth, number of values, doubled keys.
class Guard {
 public:
  explicit Guard(const std::string& source) : source_(source) {}

  bool operator()(json::parse_event_t event, const json& parsed) {
    switch (event) {
      case json::parse_event_t::object_start:
      case json::parse_event_t::array_start:
        if (levels_.size() == kMaxDepth) {
          throwBadInput(source_, path(), phrase("more than {} levels of nesting", kMaxDepth),
                        phrase("fewer"));
        }
        levels_.push_back({event == json::parse_event_t::object_start, {}, {}, 0});
        break;
      case json::parse_event_t::object_end:
      case json::parse_event_t::array_end:
        levels_.pop_back();
        countValue();
        break;
      case json::parse_event_t::key:
        levels_.back().key = parsed.get<std::string>();
        if (!levels_.back().keys.insert(levels_.back().key).second) {
          throwBadInput(source_, path(), phrase("this key twice in one object"),
                        phrase("each key once"));
        }
        break;
      case json::parse_event_t::value:
        countValue();
        break;
    }
    return true;
  }

  /// Where the parser is.
  std::string path() const {
    std::string path;
    for (const Level& level : levels_) {
      if (level.is_object) {
        if (!path.empty()) path += '.';
        path += level.key.substr(0, 40);
      } else {
        path += fmt::format("[{}]", level.index);
      }
    }
    return path;
  }

 private:
  struct Level {
    bool is_object;
    std::set<std::string> keys;
    std::string key;
    std::size_t index;
  };

  void countValue() {
    if (!levels_.empty()) ++levels_.back().index;
    if (++values_ > kMaxValues) {
      throwBadInput(source_, "", phrase("more than {} values", kMaxValues), phrase("fewer"));
    }
  }

  const std::string& source_;
  std::vector<Level> levels_;
  std::size_t values_ = 0;
};

/// Goes through a text and leaves word of how far.
class Cursor {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Cursor(const char* at, const char** read) : at_(at), read_(read) {}
  reference operator*() const { return *at_; }
  Cursor& operator++() {
    *read_ = ++at_;
    return *this;
  }
  bool operator==(const Cursor& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  const char** read_;
};

/// The parser's words without its own prefix and without the bytes it last read.
std::string reasonOf(const json::exception& error) {
  std::string reason = error.what();
  const auto start = reason.find("syntax error");
  if (start != std::string::npos) reason.erase(0, start);
  const auto bytes = reason.find("; last read");
  if (bytes != std::string::npos) reason.resize(bytes);
  return reason.substr(0, 200);
}

std::string describe(const json& value) {
  constexpr std::size_t kShown = 40;
  switch (value.type()) {
    case json::value_t::object:
      return phrase("an object");
    case json::value_t::array:
      return phrase("an array of {}", value.size());
    case json::value_t::string: {
      const auto& text = value.get_ref<const std::string&>();
      return phrase("{}{} (string)", quotedJson(text.substr(0, kShown)),
                    text.size() > kShown ? "…" : "");
    }
    default:
      return value.dump();
  }
}

}  // namespace

json parseJson(std::string_view text, const std::string& source) {
  Guard guard(source);
  const char* read = text.data();
  try {
    return json::parse(Cursor(text.data(), &read), Cursor(text.data() + text.size(), &read),
                       [&guard](int, json::parse_event_t event, const json& parsed) {
                         return guard(event, parsed);
                       });
  } catch (const json::parse_error& error) {
    const auto before = text.substr(0, std::min(error.byte > 0 ? error.byte - 1 : 0, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto column = before.size() - (before.rfind('\n') + 1) + 1;
    throw Error(ErrorCode::BadInput, phrase("{}: line {}, column {}: no valid JSON: {}", source,
                                            line, column, reasonOf(error)));
  } catch (const json::out_of_range&) {
    const std::string where = guard.path();
    // The parser has looked at what follows the number.
    const auto line = 1 + std::count(text.data(), std::max(text.data(), read - 1), '\n');
    throwBadInput(source, phrase("line {}", line) + (where.empty() ? "" : ": " + where),
                  phrase("a number too large to represent"), phrase("a finite number"));
  }
}

JsonValue JsonValue::at(const std::string& key) const {
  if (auto member = find(key)) return *std::move(member);
  for (const auto& [other, value] : json_->items()) {
    const auto meant = likelyMeant(other, {key});
    if (meant) fail(quotedJson(other), quotedJson(key));
  }
  throwBadInput(source_, pathOf(key), phrase("nothing"), phrase("this key"));
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
  const auto member = object().json_->find(key);
  if (member == json_->end()) return std::nullopt;
  return JsonValue(*member, source_, pathOf(key));
}

std::vector<JsonValue> JsonValue::items(std::size_t most) const {
  if (!json_->is_array()) fail(phrase("an array"));
  if (json_->size() > most) fail(phrase("at most {}", most));
  std::vector<JsonValue> items;
  items.reserve(json_->size());
  for (const json& item : *json_) {
    items.push_back(JsonValue(item, source_, fmt::format("{}[{}]", path_, items.size())));
  }
  return items;
}

const JsonValue& JsonValue::object() const {
  if (!json_->is_object()) fail(phrase("an object"));
  return *this;
}

double JsonValue::number(double low, double high) const {
  const double value = json_->is_number() ? json_->get<double>() : low - 1.0;
  if (!(value >= low && value <= high)) {
    fail(phrase("a number from {} to {}", formatNumber(low), formatNumber(high)));
  }
  return value + 0.0;  // -0 is 0: written as "-0" it would come back as the whole number 0
}

double JsonValue::positive(double high) const {
  const double value = json_->is_number() ? json_->get<double>() : 0.0;
  if (!(value > 0.0 && value <= high)) {
    fail(phrase("a number > 0 and at most {}", formatNumber(high)));
  }
  return value;
}

std::int64_t JsonValue::integer(std::int64_t low, std::int64_t high) const {
  const bool fits = json_->is_number_integer() &&
                    (!json_->is_number_unsigned() ||
                     json_->get<std::uint64_t>() <= static_cast<std::uint64_t>(INT64_MAX));
  const std::int64_t value = fits ? json_->get<std::int64_t>() : 0;
  if (!fits || value < low || value > high) {
    fail(phrase("a whole number from {} to {}", low, high));
  }
  return value;
}

std::string JsonValue::text(std::size_t max_bytes) const {
  if (!json_->is_string()) fail(phrase("a string"));
  const auto& text = json_->get_ref<const std::string&>();
  if (text.size() > max_bytes) {
    fail(phrase("a string of {} bytes", text.size()), phrase("at most {}", max_bytes));
  }
  return text;
}

std::string JsonValue::textOr(const std::string& key, std::size_t max_bytes,
                              const std::string& fallback) const {
  const auto member = find(key);
  return member ? member->text(max_bytes) : fallback;
}

bool JsonValue::flag() const {
  if (!json_->is_boolean()) fail(phrase("true or false"));
  return json_->get<bool>();
}

std::string JsonValue::dump() const { return json_->dump(); }

std::map<std::string, std::string> JsonValue::others(
    const std::vector<std::string_view>& known) const {
  std::map<std::string, std::string> others;
  for (const auto& [key, value] : object().json_->items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) others[key] = value.dump();
  }
  return others;
}

void JsonValue::fail(const std::string& expected) const { fail(describe(*json_), expected); }

void JsonValue::fail(const std::string& found, const std::string& expected) const {
  throwBadInput(source_, path_, found, expected);
}

std::string JsonValue::pathOf(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

std::string quotedJson(std::string_view text) {
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace handmap
