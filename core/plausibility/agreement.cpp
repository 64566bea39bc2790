#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/plausibility/checks.h"
#include "core/recording/view_reader.h"

namespace handmap {

namespace {

constexpr std::size_t kPairs = 24;   // of each kind; a sparse scan tells nothing
constexpr double kLeastTurn = 0.06;  // radians: less tells no mirror
constexpr double kMostTurn = 0.9;    // more sees other things
constexpr double kLeastMove_m = 0.7;
constexpr double kMostMove_m = 6.0;  // a street turns a robot by so much in it
constexpr std::size_t kMostRows = 400;
constexpr double kLeastRange_m = 0.5;
constexpr double kMostRange_m = 30.0;
constexpr double kAboveGround_m = 0.6;  // the ground lies on itself wherever it is put
constexpr double kFlat_m = 0.3;
constexpr std::size_t kFromPoints = 250;
constexpr std::size_t kToPoints = 700;
constexpr double kFarOff_m = 1.0;
constexpr double kBad_m = 0.15;      // mean distance of scans that do not lie on each other
constexpr double kMuchBetter = 0.6;  // times that
constexpr std::size_t kLeastPairs = 4;

struct Pair {
  std::size_t from = 0;
  std::size_t to = 0;
  Pose2 motion;  ///< by the odometry
};

struct Axes {
  float xx, xy, yx, yy;
  double odometry_scale;
  double spread = 1.0;  ///< of the directions of rays, as those of 270° that were taken for 180°
};

constexpr float kDiagonal = 0.70710678F;

/// As they are; mirrored; x right and y forward; turned around, aside, by half a right angle either
/// way; odometry in other units; other directions.
constexpr std::array<Axes, 15> kReadings{{{1, 0, 0, 1, 1.0},
                                          {1, 0, 0, -1, 1.0},
                                          {0, 1, -1, 0, 1.0},
                                          {-1, 0, 0, -1, 1.0},
                                          {0, -1, 1, 0, 1.0},
                                          {kDiagonal, -kDiagonal, kDiagonal, kDiagonal, 1.0},
                                          {kDiagonal, kDiagonal, -kDiagonal, kDiagonal, 1.0},
                                          {1, 0, 0, 1, 0.001},
                                          {1, 0, 0, 1, 0.01},
                                          {1, 0, 0, 1, 1.0, 3.0 / 2.0},
                                          {1, 0, 0, 1, 1.0, 2.0 / 3.0},
                                          {1, 0, 0, 1, 1.0, 4.0 / 3.0},
                                          {1, 0, 0, 1, 1.0, 3.0 / 4.0},
                                          {1, 0, 0, 1, 1.0, 2.0},
                                          {1, 0, 0, 1, 1.0, 1.0 / 2.0}}};
constexpr std::size_t kFirstScale = 7;
constexpr std::size_t kFirstSpread = 9;

Vec2 readAs(const Axes& axes, const Vec2& p) {
  if (axes.spread != 1.0) return p.norm() * unitVector(axes.spread * std::atan2(p.y(), p.x()));
  return {axes.xx * p.x() + axes.xy * p.y(), axes.yx * p.x() + axes.yy * p.y()};
}

std::vector<Vec2> planar(const std::vector<RangePoint>& points, std::size_t most) {
  float low = 0.0F;
  float high = 0.0F;
  for (const RangePoint& p : points) {
    low = &p == points.data() ? p.z : std::min(low, p.z);
    high = &p == points.data() ? p.z : std::max(high, p.z);
  }
  const bool is_cloud = high - low > kFlat_m;
  std::vector<Vec2> all;
  for (const RangePoint& p : points) {
    const double range_m = std::hypot(p.x, p.y);
    if (range_m < kLeastRange_m || range_m > kMostRange_m) continue;
    if (is_cloud && p.z < kAboveGround_m) continue;
    all.emplace_back(p.x, p.y);
  }
  std::vector<Vec2> some;
  const std::size_t step = all.size() / most + 1;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

/// Pairs of frames that turn, and some that only move, all along the way.
std::vector<Pair> pairsOf(const Recording& recording, const std::stop_token& stop) {
  const std::vector<std::size_t> rows = rowsWithPoints(recording);
  std::vector<Pair> turning;
  std::vector<Pair> moving;
  const std::size_t step = rows.size() / 2000 + 1;
  for (std::size_t i = 0; i < rows.size(); i += step) {
    throwIfStopped(stop);
    const auto from = recording.odometry.at(recording.rows[rows[i]].time_s);
    bool has_moved = false;
    for (std::size_t j = i + 1; from && j < std::min(rows.size(), i + kMostRows); ++j) {
      const auto to = recording.odometry.at(recording.rows[rows[j]].time_s);
      if (!to) break;
      const Pose2 motion = between(*from, *to);
      const bool next = j == i + 1;  // however far: the units may be wrong
      if (motion.position().norm() > kMostMove_m && !next) break;
      if (std::abs(motion.heading) > kMostTurn) break;
      if (std::abs(motion.heading) > kLeastTurn) {
        turning.push_back({rows[i], rows[j], motion});
        break;
      }
      if (motion.position().norm() > kLeastMove_m && !std::exchange(has_moved, true)) {
        moving.push_back({rows[i], rows[j], motion});
      }
    }
  }
  std::vector<Pair> pairs;
  for (const std::vector<Pair>* some : {&turning, &moving}) {
    const std::size_t every = some->size() / kPairs + 1;
    for (std::size_t i = 0; i < some->size(); i += every) pairs.push_back((*some)[i]);
  }
  return pairs;
}

/// Mean distance of the points of the first scan from those of the second.
double distanceBetween(const std::vector<Vec2>& from, const std::vector<Vec2>& to,
                       const Pose2& motion, const Axes& axes) {
  std::vector<Vec2> seen;
  seen.reserve(to.size());
  for (const Vec2& q : to) seen.push_back(readAs(axes, q));
  const Pose2 scaled{axes.odometry_scale * motion.x, axes.odometry_scale * motion.y,
                     motion.heading};
  const Pose2 back = inverse(scaled);
  double sum_m = 0.0;
  for (const Vec2& p : from) {
    const Vec2 there = back.toOuter(readAs(axes, p));
    double least = kFarOff_m * kFarOff_m;
    for (const Vec2& q : seen) least = std::min(least, (q - there).squaredNorm());
    sum_m += std::sqrt(least);
  }
  return sum_m / static_cast<double>(from.size());
}

struct Look {
  std::array<double, kReadings.size()> off_m{};
  int frame = 0;  ///< the first that does not lie on another
  std::size_t pairs = 0;
};

Look lookAt(const Recording& recording, const std::stop_token& stop) {
  Look look;
  bool is_told = false;
  const ViewReader reader(recording);
  for (const Pair& pair : pairsOf(recording, stop)) {
    throwIfStopped(stop);
    View from;
    View to;
    try {
      reader.readPoints(recording.rows[pair.from], from);
      reader.readPoints(recording.rows[pair.to], to);
    } catch (const Error&) {
      continue;
    }
    const auto few = planar(*from.points, kFromPoints);
    const auto many = planar(*to.points, kToPoints);
    if (few.size() < 30 || many.size() < 30) continue;
    for (std::size_t i = 0; i < kReadings.size(); ++i) {
      const double off_m = distanceBetween(few, many, pair.motion, kReadings[i]);
      look.off_m[i] += off_m;
      if (i == 0 && off_m >= kBad_m && !std::exchange(is_told, true)) {
        look.frame = recording.rows[pair.from].frame;
      }
    }
    ++look.pairs;
  }
  for (double& off_m : look.off_m)
    off_m /= static_cast<double>(std::max<std::size_t>(1, look.pairs));
  return look;
}

Doubt doubtAbout(const Recording& recording, std::size_t best, const Look& look) {
  Doubt doubt;
  const Axes& axes = kReadings[best];
  const std::string points = placeOfFrame(recording, look.frame);
  const std::string found =
      phrase("scans that lie {:.2f} m off each other along the odometry, but {:.2f} m",
             look.off_m[0], look.off_m[best]);
  doubt.code = best == 1             ? "opposite_turns"
               : best < kFirstScale  ? "points_axes"
               : best < kFirstSpread ? "odometry_units"
                                     : "ray_directions";
  if (best == 1) {
    doubt.message =
        phrase("{}: found {} with y the other way, expected both to turn alike", points, found);
    doubt.hint = phrase(
        "the sensor is mounted upside down or counts its angles clockwise (y of the "
        "points has the wrong sign), or the odometry turns the wrong way");
    doubt.remedy = Remedy{phrase("Read the points with y the other way")};
  } else if (best < kFirstScale) {
    const double turn_deg = toDegrees(std::atan2(axes.yx, axes.xx));
    doubt.message =
        phrase("{}: found {} with other axes, expected x forward and y left", points, found);
    doubt.hint = best == 2   ? phrase("the points look like x right, y forward")
                 : best == 3 ? phrase("the points look turned around: x backwards")
                             : phrase("the sensor looks turned on the robot by {:.0f}°", turn_deg);
    doubt.remedy = Remedy{best == 2   ? phrase("Read the points as x right, y forward")
                          : best == 3 ? phrase("Turn the points around")
                                      : phrase("Turn the points by {:.0f}°", turn_deg)};
  } else if (best >= kFirstSpread) {
    doubt.message = phrase(
        "{}: found {} with the rays over {:.3g} times the angle, expected each ray where it "
        "looked",
        points, found, axes.spread);
    doubt.hint =
        phrase("was another field of view meant, as 270° and not 180°? --angles of import says it");
  } else {
    doubt.message = phrase("{}: found {} with shorter motions, expected metres",
                           recording.odometry.source(), found);
    sayUnitOfOdometry(axes.odometry_scale, doubt);
  }
  doubt.remedy->points = {axes.xx, axes.xy, axes.yx, axes.yy, 1.0F, 0.0F};
  return doubt;
}

}  // namespace

std::optional<double> scaleByScans(const Recording& recording, const std::stop_token& stop) {
  const Look look = lookAt(recording, stop);
  if (look.pairs < kLeastPairs) return std::nullopt;
  const bool centimetres = look.off_m[kFirstScale + 1] < look.off_m[kFirstScale];
  return kReadings[kFirstScale + (centimetres ? 1 : 0)].odometry_scale;
}

void checkAgreement(const Recording& recording, const std::stop_token& stop, Doubts& doubts) {
  if (recording.odometry.empty()) return;
  const Look look = lookAt(recording, stop);
  if (look.pairs < kLeastPairs || look.off_m[0] < kBad_m) return;
  const auto best =
      static_cast<std::size_t>(std::ranges::min_element(look.off_m) - look.off_m.begin());
  if (best == 0 || look.off_m[best] > kMuchBetter * look.off_m[0]) return;
  doubts.push_back(doubtAbout(recording, best, look));
}

}  // namespace handmap
