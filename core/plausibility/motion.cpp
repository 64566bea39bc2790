#include <array>
#include <cmath>

#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/plausibility/checks.h"

namespace handmap {

namespace {

constexpr double kFast_mps = 45.0;  // 160 km/h
constexpr double kImpossible_mps = 100.0;
constexpr double kCentimetres_mps = 200.0;  // 2 m/s, where no scans tell
constexpr double kStep_s = 0.4;             // shorter motions are noise
constexpr double kMoving_mps = 0.02;
constexpr double kLeastWay_m = 3.0;  // of a drive that tells which way it looks
constexpr double kAgrees = 0.985;    // mean cosine of motion and heading; wheels give 0.99
constexpr double kAside = 0.9;       // what is no noise
constexpr double kAgreesElsewhere = 0.95;
constexpr double kTimesNearer = 3.0;  // times nearer to 1, where the way is hardly bent
constexpr double kGap_s = 1.0;
constexpr double kGapIntervals = 10.0;
constexpr double kGapMove_m = 1.0;
constexpr double kGapTurn = 0.35;  // radians

struct Motion {
  Vec2 way;  ///< in the odometry frame
  double heading;
  double speed_mps;
  double time_s;  ///< of the pose that it leads to
};

std::vector<Motion> motionsOf(const std::vector<StampedPose>& poses) {
  std::vector<Motion> motions;
  for (std::size_t i = 0, from = 0; i < poses.size(); ++i) {
    const double elapsed_s = poses[i].time_s - poses[from].time_s;
    if (elapsed_s < kStep_s) continue;
    const Vec2 way = poses[i].pose.position() - poses[from].pose.position();
    const double turn = normalizedAngle(poses[i].pose.heading - poses[from].pose.heading);
    motions.push_back(
        {way, poses[from].pose.heading + 0.5 * turn, way.norm() / elapsed_s, poses[i].time_s});
    from = i;
  }
  std::erase_if(motions, [](const Motion& m) { return m.speed_mps < kMoving_mps; });
  return motions;
}

void checkSpeed(const Recording& recording, const std::vector<Motion>& motions,
                const std::stop_token& stop, Doubts& doubts) {
  std::vector<double> speeds_mps;
  for (const Motion& motion : motions) speeds_mps.push_back(motion.speed_mps);
  const double speed_mps = medianOf(speeds_mps);
  if (speed_mps < kFast_mps) return;
  const double scale =
      scaleByScans(recording, stop).value_or(speed_mps < kCentimetres_mps ? 0.01 : 0.001);
  Doubt doubt;
  doubt.code = "odometry_units";
  doubt.certain = speed_mps >= kImpossible_mps;
  const auto fast = std::ranges::find_if(
      motions, [](const Motion& motion) { return motion.speed_mps >= kFast_mps; });
  doubt.message = phrase("{}: found a robot that drives {:.0f} m/s, expected metres",
                         placeOfPose(recording, fast->time_s), speed_mps);
  sayUnitOfOdometry(scale, doubt);
  doubts.push_back(std::move(doubt));
}

struct Reading {
  double sign;
  double turn;  ///< radians
};

/// Mean cosine between where it goes and where it looks: 1 is straight ahead.
double agreement(const std::vector<Motion>& motions, const Reading& reading) {
  double ahead = 0.0;
  double all = 0.0;
  for (const Motion& m : motions) {
    const double heading = reading.sign * m.heading + reading.turn;
    ahead += m.way.x() * std::cos(heading) + m.way.y() * std::sin(heading);
    all += m.way.norm();
  }
  return all > 0.0 ? ahead / all : 0.0;
}

/// Another way to count them in which it drives where it looks.
std::optional<Doubt> headingsCountedOtherwise(const Recording& recording,
                                              const std::vector<Motion>& motions, double agrees) {
  struct Other {
    Reading reading;
    std::string cause;
    std::string remedy;
  };
  const std::array others{Other{{1.0, kPi / 2},
                                phrase("headings are counted from y: x looks right, y forward"),
                                phrase("Read the headings from y")},
                          Other{{1.0, -kPi / 2},
                                phrase("x looks left or y backwards"),
                                phrase("Turn the headings to the right")},
                          Other{{-1.0, 0.0},
                                phrase("headings are counted clockwise"),
                                phrase("Read the headings clockwise")},
                          Other{{-1.0, kPi / 2},
                                phrase("headings are those of a compass, clockwise from north"),
                                phrase("Read the headings as a compass's")},
                          Other{{1.0, kPi},
                                phrase("the robot drives backwards, or x looks back"),
                                phrase("Turn the headings around")}};
  for (const Other& other : others) {
    const double agrees_so = agreement(motions, other.reading);
    const bool is_better = agrees < kAside || kTimesNearer * (1.0 - agrees_so) < 1.0 - agrees;
    if (agrees_so < kAgreesElsewhere || !is_better) continue;
    Doubt doubt;
    doubt.code = "odometry_heading";
    const auto aside = std::ranges::find_if(motions, [](const Motion& m) {
      return agreement({m}, {1.0, 0.0}) < kAgrees;
    });
    doubt.message = phrase(
        "{}: found a robot that does not drive where it looks, expected "
        "headings counter-clockwise from x, x forward and y left",
        placeOfPose(recording, aside->time_s));
    doubt.hint = phrase("likely {}", other.cause);
    doubt.remedy = Remedy{other.remedy};
    doubt.remedy->clockwise_headings = other.reading.sign < 0.0;
    doubt.remedy->odometry_turn = other.reading.turn;
    return doubt;
  }
  return std::nullopt;
}

void checkHeadings(const Recording& recording, const std::vector<Motion>& motions, Doubts& doubts) {
  double way_m = 0.0;
  for (const Motion& m : motions) way_m += m.way.norm();
  const double agrees = agreement(motions, {1.0, 0.0});
  if (way_m < kLeastWay_m || agrees >= kAgrees) return;
  if (auto otherwise = headingsCountedOtherwise(recording, motions, agrees)) {
    doubts.push_back(std::move(*otherwise));
    return;
  }
  if (agrees >= kAside) return;
  const std::string place = placeOfPose(recording, motions.front().time_s);
  const auto same = [&](const Motion& m) {
    return std::abs(m.heading - motions[0].heading) < 1e-3;
  };
  if (std::ranges::all_of(motions, same)) {
    doubts.push_back({"odometry_heading",
                      phrase("{}: found one heading all along a way that turns, expected that of "
                             "the robot",
                             place),
                      phrase("likely qx qy qz qw is not told (0 0 0 1), or w comes first"),
                      false,
                      {}});
  } else if (lookLikeDegrees(recording.odometry.poses())) {
    doubts.push_back({"odometry_heading",
                      phrase("{}: found headings that are those of the way in degrees, taken for "
                             "radians, expected qz = sin(h/2) and qw = cos(h/2) of h in radians",
                             place),
                      phrase("turn degrees into radians where the quaternions are made"),
                      true,
                      {}});
  }
}

void checkGaps(const Recording& recording, Doubts& doubts) {
  const auto& poses = recording.odometry.poses();
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    intervals_s.push_back(poses[i].time_s - poses[i - 1].time_s);
  }
  const double usual_s = medianOf(intervals_s);
  int count = 0;
  std::size_t longest = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double gap_s = intervals_s[i - 1];
    if (gap_s < kGap_s || gap_s < kGapIntervals * usual_s) continue;
    const Pose2 moved = between(poses[i - 1].pose, poses[i].pose);
    if (moved.position().norm() < kGapMove_m && std::abs(moved.heading) < kGapTurn) continue;
    const bool seen = std::ranges::any_of(recording.rows, [&](const FrameRow& row) {
      return row.time_s > poses[i - 1].time_s && row.time_s < poses[i].time_s;
    });
    if (!seen) continue;
    if (count++ == 0 || gap_s > intervals_s[longest - 1]) longest = i;
  }
  if (count == 0) return;
  doubts.push_back(
      {"odometry_gaps",
       phrase("{}: found gaps with frames in them: {}, the longest of {:.1f} s from "
              "{} s on, expected a pose each {:.2g} s",
              placeOfPose(recording, poses[longest].time_s), count, intervals_s[longest - 1],
              formatNumber(poses[longest - 1].time_s), usual_s),
       phrase("there the robot is taken to go straight at one speed; --odometry scan "
              "or visual tells more"),
       false,
       {}});
}

}  // namespace

void checkOdometry(const Recording& recording, const std::stop_token& stop, Doubts& doubts) {
  if (recording.odometry.empty()) return;
  const std::vector<Motion> motions = motionsOf(recording.odometry.poses());
  checkSpeed(recording, motions, stop, doubts);
  checkHeadings(recording, motions, doubts);
  checkGaps(recording, doubts);
}

void sayUnitOfOdometry(double scale, Doubt& doubt) {
  const bool centimetres = scale > 0.005;
  doubt.hint = centimetres ? phrase("these look like centimetres: multiply x and y by 0.01")
                           : phrase("these look like millimetres: multiply x and y by 0.001");
  doubt.remedy = Remedy{centimetres ? phrase("Read the odometry as centimetres")
                                    : phrase("Read the odometry as millimetres")};
  doubt.remedy->odometry_scale = scale;
}

}  // namespace handmap
