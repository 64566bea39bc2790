#include <algorithm>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/plausibility/checks.h"
#include "core/recording/repeated_scan.h"
#include "core/recording/view_reader.h"

namespace handmap {

namespace {

constexpr std::size_t kPointsRead = 2'000'000;  // a tenth of a second
constexpr std::size_t kMostPairs = 2000;
constexpr std::size_t kLeastLooks = 40;
constexpr std::size_t kRowsAhead = 200;  // until the robot has moved
constexpr std::size_t kLeastRepeated = 3;

/// Of the next row at which the robot has moved, in `rows`.
std::optional<std::size_t> moved(const Recording& recording, const std::vector<std::size_t>& rows,
                                 std::size_t i) {
  const auto from = recording.odometry.at(recording.rows[rows[i]].time_s);
  for (std::size_t j = i + 1; from && j < std::min(rows.size(), i + kRowsAhead); ++j) {
    const auto to = recording.odometry.at(recording.rows[rows[j]].time_s);
    if (!to) return std::nullopt;
    if (isElsewhere(between(*from, *to))) return j;
  }
  return std::nullopt;
}

}  // namespace

void checkFrozen(const Recording& recording, const std::stop_token& stop, Doubts& doubts) {
  const std::vector<std::size_t> rows = rowsWithPoints(recording);
  const ViewReader reader(recording);
  std::size_t pairs = kLeastLooks;
  std::size_t looked = 0;
  std::vector<std::size_t> repeated;  // of recording.rows
  for (std::size_t i = 0; i < rows.size(); i += rows.size() / pairs + 1) {
    throwIfStopped(stop);
    const auto next = moved(recording, rows, i);
    if (!next) continue;
    View before;
    View after;
    try {
      reader.readPoints(recording.rows[rows[i]], before);
      reader.readPoints(recording.rows[rows[*next]], after);
    } catch (const Error&) {
      continue;  // the run tells it
    }
    pairs = std::clamp(kPointsRead / (2 * before.points->size() + 1), kLeastLooks, kMostPairs);
    ++looked;
    if (isRepeated(*before.points, *after.points)) repeated.push_back(rows[*next]);
  }
  if (repeated.size() < kLeastRepeated) return;
  doubts.push_back(
      {"scans_repeated",
       phrase("{}: points: found the same scan again though the robot has moved, so {} "
              "of {} looked at, the first here, expected what is seen from there",
              placeOfFrame(recording, recording.rows[repeated.front()].frame), repeated.size(),
              looked),
       phrase("did the scanner freeze, or do rows name one file again and again?"),
       false,
       {}});
}

}  // namespace handmap
