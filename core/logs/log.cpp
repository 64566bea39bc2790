#include "core/logs/log.h"

#include <algorithm>
#include <cmath>

#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/logs/array_log.h"
#include "core/logs/table_log.h"
#include "core/recording/recording.h"
#include "core/recording/sensor_place.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostBytes = 1u << 30;

/// In the order of time; what has a time that was there is left out.
template <typename Stamped>
std::size_t sortByTime(std::vector<Stamped>& all) {
  std::ranges::stable_sort(all, {}, &Stamped::time_s);
  const std::size_t before = all.size();
  const auto same = [](const Stamped& a, const Stamped& b) { return a.time_s == b.time_s; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return before - all.size();
}

double reachOf(const Log& log) {
  if (log.reach_m) return std::clamp(*log.reach_m, kLeastReach_m, kMostReach_m);
  double farthest_m = 0.0;
  for (const LoggedScan& scan : log.scans) {
    for (const RangePoint& p : scan.points) {
      farthest_m = std::max(farthest_m, static_cast<double>(std::hypot(p.x, p.y)));
    }
  }
  return farthest_m == 0.0 ? kUsualReach_m
                           : std::clamp(std::ceil(farthest_m), kLeastReach_m, kMostReach_m);
}

}  // namespace

Log readLogs(const std::vector<fs::path>& files, const LogOptions& options,
             const std::stop_token& stop) {
  Log log;
  for (const fs::path& path : files) {
    const std::string file = path.string();
    const std::string content = readFile(path, kMostBytes);
    if (path.extension() == ".npz") {
      addArrays(parseNpz(content, file), file, options, log);
    } else if (path.extension() == ".npy") {
      addArrays({{"", parseNpy(content, file)}}, file, options, log);
    } else if (isCarmen(content)) {
      addCarmen(content, file, options, stop, log);
    } else {
      addTable(parseTable(content, file, stop), options, log);
    }
  }
  if (options.sensor) {
    for (LoggedScan& scan : log.scans)
      scan.points = placedOn(*options.sensor, std::move(scan.points));
  }
  const std::size_t repeated = sortByTime(log.scans) + sortByTime(log.poses);
  if (repeated > 0) {
    log.notes.push_back(
        phrase("{} scans and poses at a time that was there are left out", repeated));
  }
  return log;
}

std::size_t writeLog(const Log& log, const fs::path& folder, std::string name,
                     std::vector<std::string>& notes) {
  const Trajectory odometry(log.poses, name);
  if (log.scans.empty()) {
    throw Error(ErrorCode::BadInput, phrase("{}: found no scan, expected some", name),
                phrase("poses alone are no recording: give the scans, too"));
  }
  SourceInfo info;
  info.name = std::move(name);
  info.range_limit_m = reachOf(log);
  info.without_odometry = true;  // the log's own, at its rate, is written below
  std::size_t written = 0;
  {
    RecordingWriter writer(folder, info);
    for (const LoggedScan& scan : log.scans) {
      const auto pose = log.poses.empty() ? Pose2{} : odometry.at(scan.time_s);
      if (!pose) continue;
      Observation observation;
      observation.frame = static_cast<int>(written++);
      observation.time_s = scan.time_s;
      observation.odometry = *pose;
      observation.views.push_back({0.0, {}, {}, scan.points});
      writer.add(observation);
    }
  }
  if (log.poses.empty()) {
    notes.push_back(phrase("no poses: the scans are to tell the motion"));
  } else {
    writeFileAtomically(folder / "odometry.tum", formatTum(log.poses));
  }
  if (written == 0) {
    throw Error(
        ErrorCode::BadInput,
        phrase("{}: found poses from {} to {} s, expected those of the scans, {} to {} s",
               info.name, formatNumber(log.poses.front().time_s),
               formatNumber(log.poses.back().time_s), formatNumber(log.scans.front().time_s),
               formatNumber(log.scans.back().time_s)));
  }
  if (written < log.scans.size()) {
    notes.push_back(
        phrase("{} scans before or after the poses are left out", log.scans.size() - written));
  }
  return written;
}

}  // namespace handmap
