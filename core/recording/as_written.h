// What files make of what is written to them.
#pragma once

#include <string_view>

#include "core/base/text.h"
#include "core/recording/observation.h"

namespace handmap {

/// What readTum() gives of a pose that formatTum() wrote: rounded. It stays itself when it is
/// written again.
Pose2 asWritten(const Pose2& pose);
/// What a replay gives of an observation that RecordingWriter wrote.
Observation asReplayed(Observation observation);

/// Whether the file ends in this line and without a line end: it may be only a part of what was to
/// be written when the power went.
inline bool isCutOff(const TextLine& line, std::string_view content) {
  const auto end = static_cast<std::size_t>(line.text.data() + line.text.size() - content.data());
  return content.find('\n', end) == std::string_view::npos;
}

}  // namespace handmap
