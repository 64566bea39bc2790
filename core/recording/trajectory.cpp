#include "core/recording/trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/recording/as_written.h"
#include "core/recording/time_limits.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMaxTrajectoryBytes = 256u << 20;
constexpr std::size_t kMaxPoses = 5'000'000;
constexpr double kMaxCoordinate = 1e8;  // odometry may count from a distant origin
constexpr double kNormTolerance = 0.05;

double yawOf(double qx, double qy, double qz, double qw) {
  return std::atan2(2.0 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
}

std::string placeOf(const TextLine& line) { return phrase("line {}", line.number); }

/// A pose, and whether its quaternion tips the robot over by more than 60°.
struct TumLine {
  StampedPose pose;
  bool tipped = false;
};

TumLine parseTumLine(const TextLine& line, const std::string& file) {
  const auto words = splitWords(line.text);
  std::array<double, 8> v{};
  if (words.size() != v.size()) {
    throwBadInput(file, placeOf(line), phrase("{} fields", words.size()),
                  phrase("8: time x y z qx qy qz qw"));
  }
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto value = parseFinite(words[i]);
    const double limit = i == 0 ? kMaxTime_s : kMaxCoordinate;
    if (value && i == 0 && std::abs(*value) > limit) {
      throwBadInput(file, placeOf(line), fmt::format("\"{}\"", words[i].substr(0, 40)),
                    phrase("seconds; this looks like {}", likelyUnitOfTime(*value)));
    }
    if (!value || std::abs(*value) > limit) {
      throwBadInput(file, placeOf(line), fmt::format("\"{}\"", words[i].substr(0, 40)),
                    phrase("a finite number, at most {}", formatNumber(limit)));
    }
    v[i] = *value;
  }
  const double norm = std::hypot(std::hypot(v[4], v[5]), std::hypot(v[6], v[7]));
  if (std::abs(norm - 1.0) > kNormTolerance) {
    throwBadInput(file, placeOf(line), phrase("a quaternion of length {:.3g}", norm),
                  phrase("length 1"));
  }
  const double upwards = 1.0 - 2.0 * (v[4] * v[4] + v[5] * v[5]);
  return {{v[0], {v[1], v[2], yawOf(v[4], v[5], v[6], v[7])}}, upwards < 0.5};
}

/// `place()` names it, where it is to be named.
template <typename Place>
void checkOrder(double previous, double time, const std::string& source, const Place& place) {
  if (time > previous) return;
  throwBadInput(source, place(),
                phrase("time {} after {}", formatNumber(time), formatNumber(previous)),
                phrase("times that increase"));
}

}  // namespace

Trajectory::Trajectory(std::vector<StampedPose> poses, std::string source)
    : poses_(std::move(poses)), source_(std::move(source)) {
  for (std::size_t i = 1; i < poses_.size(); ++i) {
    checkOrder(poses_[i - 1].time_s, poses_[i].time_s, source_,
               [i] { return phrase("pose {}", i); });
  }
}

std::optional<Pose2> Trajectory::at(double time_s, double tolerance_s) const {
  if (poses_.empty() || !(time_s >= poses_.front().time_s - tolerance_s) ||
      !(time_s <= poses_.back().time_s + tolerance_s)) {
    return std::nullopt;
  }
  const auto after = std::upper_bound(
      poses_.begin(), poses_.end(), time_s,
      [](double time, const StampedPose& stamped) { return time < stamped.time_s; });
  if (after == poses_.begin()) return poses_.front().pose;
  if (after == poses_.end()) return poses_.back().pose;
  const StampedPose& before = *std::prev(after);
  const double t = (time_s - before.time_s) / (after->time_s - before.time_s);
  return interpolated(before.pose, after->pose, t);
}

Trajectory readTum(const std::filesystem::path& path, const std::stop_token& stop) {
  const std::string file = path.string();
  const std::string content = readFile(path, kMaxTrajectoryBytes);
  std::vector<StampedPose> poses;
  std::size_t tipped = 0;
  TextLine first_tipped{};
  ContentLines lines(content);
  while (const auto line = lines.next()) {
    throwIfStopped(stop);
    StampedPose stamped;
    try {
      const TumLine parsed = parseTumLine(*line, file);
      stamped = parsed.pose;
      if (parsed.tipped && tipped++ == 0) first_tipped = *line;
    } catch (const Error&) {
      if (poses.empty() || !isCutOff(*line, content)) throw;
      break;
    }
    if (!poses.empty()) {
      checkOrder(poses.back().time_s, stamped.time_s, file, [&] { return placeOf(*line); });
    }
    if (poses.size() == kMaxPoses) {
      throwBadInput(file, placeOf(*line), phrase("one more pose"), phrase("at most {}", kMaxPoses));
    }
    poses.push_back(stamped);
  }
  if (poses.empty()) {
    throwBadInput(file, "", phrase("no pose"), phrase("lines of time x y z qx qy qz qw"));
  }
  if (2 * tipped > poses.size()) {  // a robot on wheels
    throwBadInput(
        file, placeOf(first_tipped),
        phrase("a quaternion that tips the robot over, as {} of {} do", tipped, poses.size()),
        phrase("qx qy qz qw of x forward, y left, z up: is w the first of yours?"));
  }
  return {std::move(poses), file};
}

std::string formatTum(const std::vector<StampedPose>& poses) {
  std::string text;
  for (const auto& [time_s, pose] : poses) {
    text += fmt::format("{} {:.6f} {:.6f} 0 0 0 {:.9f} {:.9f}\n", formatNumber(time_s), pose.x,
                        pose.y, std::sin(pose.heading / 2.0), std::cos(pose.heading / 2.0));
  }
  return text;
}

Pose2 asWritten(const Pose2& pose) {
  constexpr int kMost = 8;  // of three million headings none needed more than two
  Pose2 written = pose;
  for (int i = 0; i < kMost; ++i) {
    const Pose2 again = parseTumLine({1, formatTum({{0.0, written}})}, "pose").pose.pose;
    if (again == written) break;
    written = again;
  }
  return written;
}

}  // namespace handmap
