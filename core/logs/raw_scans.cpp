#include "core/logs/raw_scans.h"

#include <algorithm>
#include <cmath>

#include "core/base/median.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/recording/laser_scan.h"
#include "core/recording/time_limits.h"

namespace handmap {

namespace {

constexpr double kLongest_m = 200.0;  // median: such ranges are no metres
constexpr double kMillimetres = 1500.0;
constexpr double kNothing_m = 0.02;    // what scanners give for "no return": 0, or their own case
constexpr double kSilentShare = 0.02;  // of all ranges at exactly the greatest one
constexpr double kSame = 1e-3;
constexpr double kMostTurn = 7.0;     // radians: more than a turn is in degrees
constexpr double kMostRate_s = 20.0;  // from scan to scan, of what counts seconds

constexpr double kSlowest_mps = 0.02;  // of robots that move
constexpr double kFastest_mps = 45.0;
constexpr double kImpossible_mps = 100.0;

double distanceOf(const RangePoint& p) { return std::hypot(p.x, p.y); }

double usualLength(const RawLog& raw) {
  std::vector<double> lengths;
  const std::size_t step = raw.scans.size() / 50 + 1;
  for (std::size_t i = 0; i < raw.scans.size(); i += step) {
    for (const double range : raw.scans[i].ranges) {
      if (std::isfinite(range) && range > 0.0) lengths.push_back(range);
    }
    for (const RangePoint& p : raw.scans[i].points) lengths.push_back(distanceOf(p));
  }
  return medianOf(std::move(lengths));
}

double metresOf(const RawLog& raw, const LogOptions& options, Log& log) {
  if (options.metres) return *options.metres;
  if (raw.metres) return *raw.metres;
  const double length = usualLength(raw);
  if (length < kLongest_m) return 1.0;
  const bool centimetres = length < kMillimetres;
  log.notes.push_back(centimetres ? phrase("{}: lengths taken as centimetres", raw.file)
                                  : phrase("{}: lengths taken as millimetres", raw.file));
  return centimetres ? 0.01 : 0.001;
}

double secondsOf(const RawLog& raw, const LogOptions& options, Log& log) {
  if (options.seconds) return *options.seconds;
  if (raw.seconds) return *raw.seconds;
  std::vector<double> intervals;
  double newest = 0.0;
  for (std::size_t i = 0; i < std::max(raw.scans.size(), raw.poses.size()); ++i) {
    const double time = i < raw.scans.size() ? raw.scans[i].time : raw.poses[i].time;
    if (i > 0) intervals.push_back(std::abs(time - newest));
    newest = time;
  }
  const double interval = medianOf(std::move(intervals));
  std::string unit = likelyUnitOfTime(newest);
  double factor = unit.empty()              ? 1.0
                  : std::abs(newest) > 1e16 ? 1e-9
                  : std::abs(newest) > 1e13 ? 1e-6
                                            : 1e-3;
  if (unit.empty() && interval > kMostRate_s) {
    factor = interval > 5e6 ? 1e-9 : interval > 1e4 ? 1e-6 : 1e-3;
    unit = factor > 1e-4   ? phrase("milliseconds")
           : factor > 1e-7 ? phrase("microseconds")
                           : phrase("nanoseconds");
  }
  if (factor < 1.0) log.notes.push_back(phrase("{}: times taken as {}", raw.file, unit));
  return factor;
}

/// Ranges of scanners come in millimetres where the poses beside them are in metres, and the other
/// way around.
double metresOfPoses(const RawLog& raw, const LogOptions& options, double metres, double seconds,
                     Log& log) {
  if (options.metres) return metres;
  if (raw.pose_metres) return *raw.pose_metres;
  std::vector<double> speeds;  // units of length a second
  for (std::size_t i = 1; i < raw.poses.size(); ++i) {
    const RawPose& from = raw.poses[i - 1];
    const RawPose& to = raw.poses[i];
    const double way = std::hypot(to.x - from.x, to.y - from.y);
    const double time_s = seconds * (to.time - from.time);
    if (way > 0.0 && time_s > 0.0) speeds.push_back(way / time_s);
  }
  if (speeds.empty()) return metres;
  const double speed = medianOf(std::move(speeds));
  if (speed * metres > kImpossible_mps) {
    log.notes.push_back(phrase("{}: poses taken as millimetres", raw.file));
    return 0.001;
  }
  if (metres == 1.0 || speed * metres >= kSlowest_mps || speed > kFastest_mps) return metres;
  log.notes.push_back(phrase("{}: poses taken as metres", raw.file));
  return 1.0;
}

double radiansOf(const RawLog& raw, const LogOptions& options, Log& log) {
  if (options.radians) return *options.radians;
  if (raw.radians) return *raw.radians;
  const bool degrees = std::ranges::any_of(
      raw.poses, [](const RawPose& pose) { return std::abs(pose.heading) > kMostTurn; });
  if (!degrees) return 1.0;
  log.notes.push_back(phrase("{}: headings taken as degrees", raw.file));
  return toRadians(1.0);
}

/// The range that stands for silence: many are exactly the greatest.
std::optional<double> silentRange(const RawLog& raw, double metres) {
  double greatest = 0.0;
  std::size_t all = 0;
  for (const RawScan& scan : raw.scans) {
    for (const double range : scan.ranges) {
      if (std::isfinite(range)) greatest = std::max(greatest, metres * range);
      ++all;
    }
  }
  std::size_t same = 0;
  for (const RawScan& scan : raw.scans) {
    same += static_cast<std::size_t>(std::ranges::count_if(
        scan.ranges, [&](double range) { return metres * range > greatest - kSame; }));
  }
  const bool many = static_cast<double>(same) > kSilentShare * static_cast<double>(all);
  return many && same > 1 ? std::optional(greatest - kSame) : std::nullopt;
}

std::vector<RangePoint> pointsOf(const std::vector<double>& ranges, const RayAngles& angles,
                                 double metres, double most_m) {
  std::vector<RangePoint> points;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double range_m = metres * ranges[i];
    if (!std::isfinite(range_m) || range_m < kNothing_m || range_m >= most_m) continue;
    const double angle = angles.first + static_cast<double>(i) * angles.step;
    points.push_back({static_cast<float>(range_m * std::cos(angle)),
                      static_cast<float>(range_m * std::sin(angle)), 0.0F, 1.0F});
  }
  return points;
}

RayAngles anglesOf(const RawLog& raw, const LogOptions& options, std::size_t count, Log& log) {
  if (options.angles) return *options.angles;
  if (raw.angles) return *raw.angles;
  if (const auto usual = usualAngles(count)) {
    const double last = usual->first + static_cast<double>(count - 1) * usual->step;
    log.notes.push_back(phrase("{}: {} ranges a scan taken as {:.1f}° to {:.1f}°, left is positive",
                               raw.file, count, toDegrees(usual->first), toDegrees(last)));
    return *usual;
  }
  throw Question(
      "angles",
      phrase("{}: found {} ranges a scan, expected the directions they look", raw.file, count),
      phrase("FIRST:STEP in degrees, 0 ahead, positive to the left, as -90:0.5"));
}

/// Scaled; what no scanner sees is left out.
void scale(std::vector<RangePoint>& points, double metres) {
  const auto factor = static_cast<float>(metres);
  for (RangePoint& p : points) p = {factor * p.x, factor * p.y, factor * p.z, p.w};
  const auto is_near = [](float value) { return std::abs(value) <= kFarthestPoint_m; };
  std::erase_if(
      points, [&](const RangePoint& p) { return !is_near(p.x) || !is_near(p.y) || !is_near(p.z); });
}

}  // namespace

std::optional<RayAngles> usualAngles(std::size_t ranges) {
  struct Scanner {
    std::size_t ranges;
    double first_deg;
    double step_deg;
  };
  constexpr Scanner kScanners[] = {
      {180, -90, 1},          {181, -90, 1},         {360, -90, 0.5},    {361, -90, 0.5},
      {541, -135, 0.5},       {540, -135, 0.5},      {1081, -135, 0.25}, {1080, -135, 0.25},
      {682, -119.88, 0.3516}, {683, -119.88, 0.3516}};
  for (const Scanner& scanner : kScanners) {
    if (scanner.ranges == ranges) {
      return RayAngles{toRadians(scanner.first_deg), toRadians(scanner.step_deg)};
    }
  }
  return std::nullopt;
}

void addRaw(const RawLog& raw, const LogOptions& options, Log& log) {
  const double metres = metresOf(raw, options, log);
  const double seconds = secondsOf(raw, options, log);
  const double pose_metres = metresOfPoses(raw, options, metres, seconds, log);
  const double radians = radiansOf(raw, options, log);
  const auto ranges =
      std::ranges::find_if(raw.scans, [](const RawScan& scan) { return !scan.ranges.empty(); });
  std::optional<RayAngles> angles;
  if (ranges != raw.scans.end()) angles = anglesOf(raw, options, ranges->ranges.size(), log);
  auto most_m = options.most_range_m ? options.most_range_m : raw.most_range_m;
  if (!most_m) most_m = silentRange(raw, metres);
  if (most_m) {
    log.reach_m = std::max(log.reach_m.value_or(0.0), *most_m);
    log.notes.push_back(
        phrase("{}: ranges from {:.2f} m on taken as nothing that came back", raw.file, *most_m));
  }
  for (const RawScan& scan : raw.scans) {
    LoggedScan logged{seconds * scan.time, scan.points};
    scale(logged.points, metres);
    if (!scan.ranges.empty()) {
      logged.points = pointsOf(scan.ranges, *angles, metres, most_m.value_or(1e9));
    }
    log.scans.push_back(std::move(logged));
  }
  for (const RawPose& pose : raw.poses) {
    const bool finite = std::isfinite(pose.time) && std::isfinite(pose.x) &&
                        std::isfinite(pose.y) && std::isfinite(pose.heading);
    if (!finite) continue;
    log.poses.push_back(
        {seconds * pose.time,
         {pose_metres * pose.x, pose_metres * pose.y, normalizedAngle(radians * pose.heading)}});
  }
}

}  // namespace handmap
