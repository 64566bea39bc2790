// JSON from outside: parsed within bounds, and read with messages that name the file and the path.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace handmap {

/// Throws BadInput: a syntax error (with line and column), a number too large for a double (with
/// line and path), a key twice in one object (with its path), nesting deeper than 64 or more than 8
/// million values. `source` names the text.
nlohmann::json parseJson(std::string_view text, const std::string& source);

/// A view of one value of a parsed text, which must outlive it. Whatever reads it throws BadInput
/// "SOURCE: buildings[3].width: found …, expected …" when the value is not as asked.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& json, std::string source)
      : JsonValue(json, std::move(source), {}) {}

  /// A member of this object; throws where it is missing.
  JsonValue at(const std::string& key) const;
  std::optional<JsonValue> find(const std::string& key) const;
  std::vector<JsonValue> items(std::size_t most) const;  ///< of an array of at most so many
  const JsonValue& object() const;                       ///< itself, when it is an object

  double number(double low, double high) const;
  double positive(double high) const;  ///< in (0, high]
  std::int64_t integer(std::int64_t low, std::int64_t high) const;
  std::string text(std::size_t max_bytes) const;
  std::string textOr(const std::string& key, std::size_t max_bytes,
                     const std::string& fallback) const;  ///< of a member that may be missing
  bool flag() const;
  /// The value as JSON text, the same for equal values.
  std::string dump() const;
  /// Members of this object that `known` does not name: key → JSON text.
  std::map<std::string, std::string> others(const std::vector<std::string_view>& known) const;

  const std::string& source() const { return source_; }
  const std::string& path() const { return path_; }
  [[noreturn]] void fail(const std::string& expected) const;
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

 private:
  JsonValue(const nlohmann::json& json, std::string source, std::string path)
      : json_(&json), source_(std::move(source)), path_(std::move(path)) {}
  std::string pathOf(const std::string& key) const;

  const nlohmann::json* json_;
  std::string source_;
  std::string path_;
};

/// `text` as a JSON string, in quotes.
std::string quotedJson(std::string_view text);

}  // namespace handmap
