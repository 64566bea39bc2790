#include "core/plausibility/places.h"

#include <optional>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMostBytes = 256U << 20U;  // as is read of a recording

/// The files were read before; what tells of them does not carry the lines of all poses about.
template <typename Is>
std::string placeIn(const std::filesystem::path& file, const Is& is) {
  try {
    const std::string content = readFile(file, kMostBytes);
    ContentLines lines(content);
    while (const auto line = lines.next()) {
      if (is(line->text)) return phrase("{}: line {}", file.string(), line->number);
    }
  } catch (const Error&) {  // it has gone meanwhile
  }
  return file.string();
}

}  // namespace

std::string placeOfPose(const Recording& recording, double time_s) {
  return placeIn(recording.odometry.source(), [time_s](std::string_view line) {
    const auto words = splitWords(line.substr(0, line.find_first_of(" \t", 1)));
    // Lines of other forms do not tell times.
    return !words.empty() && parseFinite(words[0]) == time_s && splitWords(line).size() == 8;
  });
}

std::string placeOfFrame(const Recording& recording, int frame) {
  return placeIn(recording.folder / "frames.csv", [frame](std::string_view line) {
    return parseInteger(line.substr(0, line.find(','))) == frame;
  });
}

}  // namespace handmap
