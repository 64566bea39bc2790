#include "core/base/text.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

template <typename Number>
std::optional<Number> parseWhole(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

}  // namespace

std::optional<double> parseFinite(std::string_view text) {
  const auto value = parseWhole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> parseInteger(std::string_view text) {
  return parseWhole<std::int64_t>(text);
}

std::string formatNumber(double value) { return fmt::format("{}", value); }

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> splitFields(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    const auto end = line.find(separator);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

std::vector<std::string_view> splitWords(std::string_view line) {
  std::vector<std::string_view> words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const auto end = std::min(line.find_first_of(kBlanks), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

std::string readFile(const fs::path& path, std::uintmax_t limit_bytes) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (!fs::exists(status)) {
    throwBadInput(path.string(), "", phrase("no such file"), phrase("a readable file"));
  }
  if (!fs::is_regular_file(status)) {
    throwBadInput(path.string(), "", phrase("no regular file"), phrase("a file"));
  }
  const auto size = fs::file_size(path, error);
  if (!error && size > limit_bytes) {
    throwBadInput(path.string(), "", phrase("{} bytes", size),
                  phrase("at most {} bytes", limit_bytes));
  }
  std::ifstream stream(path, std::ios::binary);
  std::string content(error ? 0 : size, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (error || !stream) {
    throwBadInput(path.string(), "", fmt::format("\"{}\"", std::strerror(errno)),
                  phrase("a readable file"));
  }
  return content;
}

bool fileExists(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

bool staysInside(const fs::path& relative) {
  return relative.is_relative() && std::none_of(relative.begin(), relative.end(),
                                                [](const fs::path& part) { return part == ".."; });
}

ContentLines::ContentLines(std::string_view content) : rest_(content) {
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

std::optional<TextLine> ContentLines::next() {
  while (!rest_.empty()) {
    ++number_;
    const auto end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view text = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!text.empty() && !text.starts_with('#')) return TextLine{number_, text};
  }
  return std::nullopt;
}

}  // namespace handmap
