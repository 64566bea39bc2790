#include "core/trajectory/odometry_choice.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/odometry/visual_odometry_source.h"
#include "core/perception/joined_frames.h"
#include "core/trajectory/constants.h"
#include "core/trajectory/scan_odometry_source.h"
#include "core/trajectory/scan_trajectory.h"

namespace handmap {

using namespace trajectory;

namespace {

/// What the range sensor saw, placed by each odometry.
struct Look {
  explicit Look(double range_limit_m) : seen({range_limit_m, false}) {}

  ScanTrajectory seen;
  std::vector<double> times_s;
  std::vector<Pose2> by_scans;
};

std::optional<Observation> nextReadable(ObservationSource& source) {
  while (true) {
    try {
      return source.next();
    } catch (const FrameError&) {
      continue;  // the run that follows tells it
    }
  }
}

Look lookedAt(const Recording& recording, ReplayOptions options) {
  options.kind = SourceKind::Points;
  const auto source = replay(recording, options);
  Look look(source->info().range_limit_m);
  JoinedFrames joined;
  while (const auto observation = nextReadable(*source)) {
    SeenPoints seen = allPoints(*observation);
    joined.removeRepeats(seen, observation->odometry);
    if (joined.areJoined()) look.seen.setJoined();
    look.seen.add(observation->time_s, observation->odometry, seen.points, {}, seen.ids);
    look.times_s.push_back(observation->time_s);
    look.by_scans.push_back(look.seen.odometry());
  }
  return look;
}

/// By the images, at every time; empty where they do not tell it.
Trajectory visualTrajectory(const Recording& recording, ReplayOptions options) {
  options.kind = SourceKind::Images;
  options.every = 1;
  options.visual_odometry = true;
  std::vector<StampedPose> poses;
  try {
    const auto source = withVisualOdometry(replay(recording, options));
    while (const auto observation = nextReadable(*source)) {
      poses.push_back({observation->time_s, observation->odometry});
    }
  } catch (const Error&) {
    return {};
  }
  return {std::move(poses), recording.name};
}

/// nullopt where the way does not reach.
std::optional<std::vector<Pose2>> placedAt(const std::vector<double>& times_s,
                                           const Trajectory& trajectory) {
  std::vector<Pose2> poses;
  for (const double time_s : times_s) {
    const auto pose = trajectory.at(time_s);
    if (!pose) return std::nullopt;
    poses.push_back(*pose);
  }
  return poses;
}

bool hasPoints(const Recording& recording) {
  return std::any_of(recording.rows.begin(), recording.rows.end(),
                     [](const FrameRow& row) { return !row.points.empty(); });
}

bool hasImages(const Recording& recording) {
  return std::any_of(recording.rows.begin(), recording.rows.end(),
                     [](const FrameRow& row) { return !row.left.empty(); });
}

bool replaysImages(const Recording& recording, const ReplayOptions& options) {
  if (options.kind != SourceKind::Auto) return options.kind == SourceKind::Images;
  return hasImages(recording);
}

/// What was chosen and, where it is visual odometry for a run that sees with points, its way.
struct Verdict {
  OdometryKind kind = OdometryKind::Recorded;
  std::string reason;
  Trajectory visual;
};

Verdict judged(const Recording& recording, const ReplayOptions& options) {
  const Look look = lookedAt(recording, options);
  const double recorded = look.seen.sharpness(look.seen.recorded());
  Verdict verdict;
  verdict.reason = fmt::format("sharpness {:.3f} recorded", recorded);
  double best = recorded + kClearlySharper;
  if (!replaysImages(recording, options)) {
    const double scans = look.seen.sharpness(look.by_scans);
    verdict.reason += fmt::format(", {:.3f} scan", scans);
    if (!look.seen.usable()) verdict.reason += " (too few straight pieces, or not sharper)";
    if (look.seen.usable() && scans > best) {
      best = scans;
      verdict.kind = OdometryKind::Scan;
    }
  }
  if (!hasImages(recording) || !recording.camera) return verdict;
  verdict.visual = visualTrajectory(recording, options);
  const auto placed = placedAt(look.times_s, verdict.visual);
  if (!placed) return verdict;
  const double visual = look.seen.sharpness(*placed);
  verdict.reason += fmt::format(", {:.3f} visual", visual);
  if (visual > best) verdict.kind = OdometryKind::Visual;
  return verdict;
}

Verdict automatic(const Recording& recording, const ReplayOptions& options) {
  if (recording.odometry.empty() && options.odometry.empty()) {
    const auto kind = replaysImages(recording, options) ? OdometryKind::Visual : OdometryKind::Scan;
    return {kind, "nothing recorded", {}};
  }
  if (!hasPoints(recording)) {
    return {OdometryKind::Recorded, "no range points to compare by", {}};
  }
  return judged(recording, options);
}

std::unique_ptr<ObservationSource> withScans(const Recording& recording, ReplayOptions options) {
  if (replaysImages(recording, options)) {
    throwBadInput(recording.folder.string(), "", phrase("images chosen to see with"),
                  phrase("range points for odometry from scans: --source points"));
  }
  options.kind = SourceKind::Points;
  options.without_odometry = recording.odometry.empty() && options.odometry.empty();
  auto source = replay(recording, options);
  return options.without_odometry ? withScansAlone(std::move(source))
                                  : withScanOdometry(std::move(source));
}

}  // namespace

std::string nameOf(OdometryKind kind) {
  switch (kind) {
    case OdometryKind::Recorded:
      return "recorded";
    case OdometryKind::Visual:
      return "visual";
    case OdometryKind::Scan:
      return "scan";
    case OdometryKind::Auto:
      break;
  }
  return "auto";
}

ChosenOdometry replayWithOdometry(Recording recording, ReplayOptions options, OdometryKind kind) {
  ChosenOdometry choice;
  choice.kind = kind;
  if (kind == OdometryKind::Auto) {
    Verdict verdict = automatic(recording, options);
    choice.kind = verdict.kind;
    choice.reason = std::move(verdict.reason);
    if (verdict.kind == OdometryKind::Visual && !replaysImages(recording, options)) {
      recording.odometry = std::move(verdict.visual);
      options.odometry.clear();
      choice.source = replay(std::move(recording), options);
      return choice;
    }
  }
  const bool nothing_recorded = recording.odometry.empty() && options.odometry.empty();
  if (choice.kind == OdometryKind::Recorded && nothing_recorded && hasPoints(recording) &&
      !replaysImages(recording, options)) {
    choice.kind = OdometryKind::Scan;
  }
  if (choice.kind == OdometryKind::Scan) {
    choice.source = withScans(recording, std::move(options));
    return choice;
  }
  options.visual_odometry = choice.kind == OdometryKind::Visual;
  choice.source = replayWithOdometry(std::move(recording), std::move(options));
  return choice;
}

}  // namespace handmap
