// Reading and writing text whatever the locale, with bounds, and files replaced only when whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handmap {

/// A number in C notation that fills `text` (blanks around it allowed); nullopt for anything else,
/// infinities and NaN included.
std::optional<double> parseFinite(std::string_view text);
std::optional<std::int64_t> parseInteger(std::string_view text);

/// The shortest text that reads back as the same value.
std::string formatNumber(double value);

std::string_view trimmed(std::string_view text);
/// "a,,b" → {"a", "", "b"}; fields are trimmed.
std::vector<std::string_view> splitFields(std::string_view line, char separator);
/// Splits at runs of blanks and tabs.
std::vector<std::string_view> splitWords(std::string_view line);

/// The whole file. Throws BadInput when it is missing, not a regular file or larger than the limit.
std::string readFile(const std::filesystem::path& path, std::uintmax_t limit_bytes);

/// Whether there is something at `path` that may be looked at.
bool fileExists(const std::filesystem::path& path);
/// Whether a path that a file names stays inside the folder that it is relative to.
bool staysInside(const std::filesystem::path& relative);

struct TextLine {
  int number;  ///< 1-based, as an editor counts
  std::string_view text;
};
/// Goes through the lines of `content` (which must outlive it) that are neither empty nor begin
/// with
/// '#', without their line ends.
class ContentLines {
 public:
  explicit ContentLines(std::string_view content);
  std::optional<TextLine> next();

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// The target is the old file or the whole new one, on disk, with the old one's permissions and, if
/// it may be, owner; links stay links. Throws RunFailed with the reason of the system.
void writeFileAtomically(const std::filesystem::path& path, std::string_view content);

}  // namespace handmap
