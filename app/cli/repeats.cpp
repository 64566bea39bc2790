#include "app/cli/repeats.h"

#include <fmt/format.h>

namespace handmap {

namespace {

std::string withoutNumbers(const std::string& message) {
  std::string kind;
  for (const char c : message) {
    const bool is_number = (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
    if (!is_number) {
      kind += c;
    } else if (kind.empty() || kind.back() != '#') {
      kind += '#';
    }
  }
  return kind;
}

}  // namespace

bool Repeats::isNews(const std::string& message) {
  Kind& kind = kinds_[withoutNumbers(message)];
  if (kind.count == 0) kind.first = message;
  return ++kind.count <= kSaid;
}

std::string Repeats::counted() {
  std::string text;
  for (const auto& [key, kind] : kinds_) {
    if (kind.count <= kSaid) continue;
    text += fmt::format("handmap-cli: {} more like: {}\n", kind.count - kSaid, kind.first);
  }
  kinds_.clear();
  return text;
}

}  // namespace handmap
