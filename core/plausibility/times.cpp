#include <algorithm>
#include <cmath>

#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/plausibility/checks.h"

namespace handmap {

namespace {

// Between the frames of a moving robot: the shorter ones may be a slow time lapse, the others not.
constexpr double kMilliseconds = 20.0;
constexpr double kMicroseconds = 1e4;
constexpr double kNanoseconds = 5e6;
constexpr double kLeastCovered = 0.01;  // less is a chance, of units that differ
constexpr int kLeastPoses = 3;          // while so many frames were taken
constexpr std::size_t kManyRows = 20;
constexpr double kBetweenStops = 200.0;  // times as long as between frames

struct Unit {
  std::string name;
  double seconds;
};

Unit unitOf(double interval_s) {
  if (interval_s >= kNanoseconds) return {phrase("nanoseconds"), 1e-9};
  if (interval_s >= kMicroseconds) return {phrase("microseconds"), 1e-6};
  return {phrase("milliseconds"), 1e-3};
}

void checkIntervals(const Recording& recording, Doubts& doubts) {
  std::vector<double> intervals_s;
  const auto& rows = recording.rows;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool same_stop = rows[i].stop && rows[i].stop == rows[i - 1].stop;
    if (!same_stop) intervals_s.push_back(rows[i].time_s - rows[i - 1].time_s);
  }
  const double interval_s = medianOf(intervals_s);
  const bool stops = std::ranges::any_of(rows, [](const FrameRow& row) { return bool(row.stop); });
  if (interval_s < (stops ? kBetweenStops : 1.0) * kMilliseconds) return;
  const Unit unit = unitOf(stops ? interval_s / kBetweenStops : interval_s);
  Doubt doubt;
  doubt.code = "time_units";
  doubt.message = phrase("{}: time_s: found {:.4g} s from frame to frame, expected seconds",
                         placeOfFrame(recording, rows[1].frame), interval_s);
  doubt.hint =
      phrase("these look like {}: multiply time_s by {}", unit.name, formatNumber(unit.seconds));
  doubt.certain = unit.seconds < 1e-3;
  doubt.remedy = Remedy{phrase("Read the times as {}", unit.name)};
  doubt.remedy->time_scale = unit.seconds;
  doubts.push_back(std::move(doubt));
}

/// What is likely, of two spans of time that have nothing in common.
std::string causeOf(const Recording& recording) {
  const auto& rows = recording.rows;
  const auto& poses = recording.odometry.poses();
  const double frames_s = rows.back().time_s - rows.front().time_s;
  const double odometry_s = poses.back().time_s - poses.front().time_s;
  const double ratio = odometry_s > 0.0 ? frames_s / odometry_s : 1.0;
  for (const double factor : {1e3, 1e6, 1e9}) {
    const Unit unit = factor > 1e8   ? Unit{phrase("nanoseconds"), 1e-9}
                      : factor > 1e5 ? Unit{phrase("microseconds"), 1e-6}
                                     : Unit{phrase("milliseconds"), 1e-3};
    if (ratio > 0.5 * factor && ratio < 2.0 * factor) {
      return phrase("the frames look like {}, the odometry like seconds", unit.name);
    }
    if (ratio * factor > 0.5 && ratio * factor < 2.0) {
      return phrase("the odometry looks like {}, the frames like seconds", unit.name);
    }
  }
  return phrase("two clocks: the frames begin at {} s, the odometry at {} s; give both the same",
                formatNumber(rows.front().time_s), formatNumber(poses.front().time_s));
}

/// Whether frames and odometry are of one.
bool checkClocks(const Recording& recording, Doubts& doubts) {
  if (recording.odometry.empty() || recording.rows.empty()) return true;
  const auto& poses = recording.odometry.poses();
  const double first = recording.rows.front().time_s;
  const double last = recording.rows.back().time_s;
  const auto inside = std::ranges::count_if(poses, [&](const StampedPose& stamped) {
    return stamped.time_s >= first && stamped.time_s <= last;
  });
  const bool few = inside < kLeastPoses && recording.rows.size() > kManyRows;
  const double covered =
      std::min(last, poses.back().time_s) - std::max(first, poses.front().time_s);
  const bool overlap = covered >= std::max(0.0, kLeastCovered * (last - first));
  if (overlap && !few) return true;
  doubts.push_back(
      {"two_clocks",
       phrase("{}: found times from {} to {} s, expected those of the frames, {} to "
              "{} s",
              placeOfPose(recording, poses.front().time_s), formatNumber(poses.front().time_s),
              formatNumber(poses.back().time_s), formatNumber(first), formatNumber(last)),
       causeOf(recording),
       true,
       {}});
  return false;
}

}  // namespace

void checkTimes(const Recording& recording, Doubts& doubts) {
  // The remedy of a unit is for both.
  if (checkClocks(recording, doubts)) checkIntervals(recording, doubts);
}

}  // namespace handmap
