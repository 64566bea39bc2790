#include "core/session/run_warnings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/map/certainty.h"
#include "core/method/constants.h"
#include "core/method/recognition.h"
#include "core/odometry/given_poses.h"

namespace handmap {

namespace {

constexpr double kMostlyBlind = 0.5;     // share of the observations, or of the way
constexpr float kLikelyWall = 0.2F;      // a return less sure of being a wall is not counted
constexpr std::size_t kPlaces = 100;     // enough to tell how near a way comes to a building
constexpr double kNearSighted_m = 20.0;  // from there on a camera sees houses by a street

std::string checkStart() {
  return phrase("Is the start where the recording begins, and does it look the right way?");
}

/// At places all along the way: how far it is to the nearest of the buildings.
template <typename Counts>
std::vector<double> nearestAlong(const std::vector<StampedPose>& trajectory,
                                 const std::vector<Building>& buildings, const Counts& counts) {
  std::vector<double> nearest_m;
  const std::size_t step = std::max<std::size_t>(1, trajectory.size() / kPlaces);
  for (std::size_t i = 0; i < trajectory.size(); i += step) {
    nearest_m.push_back(std::numeric_limits<double>::infinity());
    for (const Building& building : buildings) {
      if (!counts(building)) continue;
      nearest_m.back() = std::min(nearest_m.back(),
                                  distanceTo(building.footprint(), trajectory[i].pose.position()));
    }
  }
  return nearest_m;
}

double nearestBuilding_m(const Map& drawing, const std::vector<StampedPose>& trajectory) {
  const auto nearest_m =
      nearestAlong(trajectory, drawing.buildings, [](const Building&) { return true; });
  return nearest_m.empty() ? std::numeric_limits<double>::infinity()
                           : *std::min_element(nearest_m.begin(), nearest_m.end());
}

/// What was seen, and what to try.
struct Finding {
  std::string seen;
  std::string hint;
};

Finding noWalls(const RunOutcome& outcome) {
  const RunCounts& counts = outcome.counts;
  if (counts.images) {
    return {
        phrase("Nothing in the images was taken for the wall of a building."),
        phrase("Look at the crosses on the camera images; teach your own buildings where they are "
               "missing, or take every wall for one (--model none).")};
  }
  if (counts.points == 0) {
    return {phrase("Nothing came back from within {:.0f} m.", outcome.range_limit_m),
            phrase("Are the points in metres, x forward and y left, and range_limit_m that of the "
                   "sensor?")};
  }
  return {
      phrase("None of {} returns was taken for a wall: points of several heights count "
             "where some stand above one another, and these are too sparse for that.",
             counts.points),
      phrase(
          "Give denser clouds, or one height for all points (z = 0): then each counts as it is.")};
}

Finding nothingRecognised(const RunOutcome& outcome) {
  const RunCounts& counts = outcome.counts;
  if (counts.walls == 0) return noWalls(outcome);
  const std::string walls = phrase("Walls were seen in {} directions, up to {:.0f} m away",
                                   counts.walls, counts.farthest_m);
  const double nearest = nearestBuilding_m(outcome.drawing, outcome.trajectory);
  if (nearest > outcome.range_limit_m) {
    return {phrase("{}, but the way comes no nearer than {:.0f} m to a drawn building, and the "
                   "sensor sees {:.0f} m.",
                   walls, nearest, outcome.range_limit_m),
            checkStart()};
  }
  return {
      phrase("{}, but none is long and straight enough, or near enough to where a building is "
             "drawn.",
             walls),
      phrase("Check where the start is and which way it looks; leave the scale and the turn of the "
             "drawing free; draw what stands along the way.")};
}

RunWarning nothingCorrected(const RunOutcome& outcome) {
  const auto& buildings = outcome.drawing.buildings;
  const double nearest = nearestBuilding_m(outcome.drawing, outcome.trajectory);
  RunWarning warning{
      "nothing_corrected",
      phrase("Nothing was corrected: buildings were in sight in {} of {} observations, but none "
             "of them was taken for a drawn one.",
             outcome.counts.with_building, outcome.counts.observations),
      checkStart()};
  if (std::all_of(buildings.begin(), buildings.end(), [](const Building& b) { return b.fixed; })) {
    warning.hint = phrase("All buildings of the drawing are fixed.");
  } else if (nearest > outcome.range_limit_m) {
    warning.message += phrase(" The way comes no nearer than {:.0f} m to one.", nearest);
  } else if (outcome.counts.images && outcome.counts.farthest_m < kNearSighted_m) {
    warning.message +=
        phrase(" The cameras saw no wall beyond {:.0f} m: farther away they are too imprecise.",
               outcome.counts.farthest_m);
    warning.hint = phrase(
        "Drive closer to the walls, or with cameras that are farther apart or have more pixels.");
  } else {
    warning.hint += phrase(" Leave the scale and the turn of the drawing free.");
  }
  return warning;
}

/// Share of the way that has no corrected building within the sensor's range.
double shareAlone(const RunOutcome& outcome) {
  const auto nearest_m = nearestAlong(outcome.trajectory, outcome.refined.buildings, isRecognised);
  const auto alone = std::count_if(nearest_m.begin(), nearest_m.end(), [&](double distance_m) {
    return distance_m > outcome.range_limit_m;
  });
  return static_cast<double>(alone) /
         static_cast<double>(std::max<std::size_t>(1, nearest_m.size()));
}

std::vector<RunWarning> warningsOfRecognition(const RunOutcome& outcome) {
  const RunCounts& counts = outcome.counts;
  const auto& buildings = outcome.refined.buildings;
  if (counts.with_building == 0) {
    const Finding finding = nothingRecognised(outcome);
    return {{"nothing_recognised",
             phrase("No building was recognised in {} observations: the drawing is as it was, "
                    "and the way is that of the motion alone. {}",
                    counts.observations, finding.seen),
             finding.hint}};
  }
  if (outcome.refine && std::none_of(buildings.begin(), buildings.end(), isRecognised)) {
    const bool told = std::ranges::any_of(
        outcome.of_method, [](const RunWarning& w) { return w.code == "buildings_dropped"; });
    if (told) return {};
    return {nothingCorrected(outcome)};
  }
  const int blind = counts.observations - counts.with_building;
  if (blind > kMostlyBlind * counts.observations) {
    return {{"way_from_odometry",
             phrase("No building was in sight in {} of {} observations: there the way is that of "
                    "the motion alone.",
                    blind, counts.observations),
             phrase("Draw more of what stands along the way.")}};
  }
  if (const double alone = shareAlone(outcome); outcome.refine && alone > kMostlyBlind) {
    return {
        {"way_from_odometry",
         phrase("Along {:.0f} % of the way, none of the drawn buildings that were recognised is "
                "within the {:.0f} m that the sensor sees: there the way is that of the motion "
                "alone.",
                100.0 * alone, outcome.range_limit_m),
         phrase("{} If so, draw more of what stands along the way.", checkStart())}};
  }
  if (outcome.unrecognised_m >= method::kUnrecognised_m) {
    return {
        {"end_unrecognised",
         phrase("Nothing of the drawing was recognised on the last {:.0f} m: the robot may have "
                "been elsewhere all the way, however well the buildings before fitted.",
                outcome.unrecognised_m),
         phrase("{} If so, draw more of what stands along the way.", checkStart())}};
  }
  if (counts.unrecognised_m >= method::kUnrecognised_m) {
    return {
        {"part_unrecognised",
         phrase(
             "Nothing of the drawing was recognised for {:.0f} m on the way, up to {} s: nothing "
             "tells whether the robot was where it is shown there.",
             counts.unrecognised_m, formatNumber(counts.unrecognised_until_s)),
         phrase("Draw what stands there; where it is drawn, check the start.")}};
  }
  return {};
}

/// Where a person has said two things that cannot both be meant.
std::optional<RunWarning> warningOfStart(const RunOutcome& outcome) {
  if (!outcome.drawn_start) return std::nullopt;
  const Eigen::Vector3d hand = std::sqrt(2.0) * handSigma();
  const Pose2 moved = between(*outcome.drawn_start, *outcome.drawing.start);
  const double off_m = moved.position().norm();
  if (off_m < hand.x() && std::abs(moved.heading) < hand.z()) return std::nullopt;
  return RunWarning{
      "start_moved",
      phrase("The poses that were given do not go with the drawn start: the run began {:.1f} m and "
             "{:.0f}° off it.",
             off_m, std::abs(toDegrees(moved.heading))),
      phrase("If the start is right, take the given poses back.")};
}

}  // namespace

void RunCounts::add(const Percept& percept, const FrameReport& report) {
  ++observations;
  if (report.visible_buildings > 0) ++with_building;
  start_refuted = report.start_refuted;
  if (report.odometry_guessed && guessed++ == 0) guessed_s = report.time_s;
  if (report.unrecognised_m > unrecognised_m) {
    unrecognised_m = report.unrecognised_m;
    unrecognised_until_s = report.time_s;
  }
  points += percept.points.size();
  for (const Ray& ray : percept.scan.rays) {
    if (!ray.returned || ray.wall < kLikelyWall) continue;
    ++walls;
    farthest_m = std::max(farthest_m, static_cast<double>(ray.range));
  }
}

std::vector<RunWarning> runWarnings(const RunOutcome& outcome) {
  constexpr int kLeastGuessed = 3;  // one or two go on well enough at the speed of before
  std::vector<RunWarning> warnings = outcome.of_method;
  const std::vector<RunWarning> of_recognition = warningsOfRecognition(outcome);
  warnings.insert(warnings.end(), of_recognition.begin(), of_recognition.end());
  const RunCounts& counts = outcome.counts;
  if (counts.guessed >= kLeastGuessed) {
    warnings.push_back(
        {"motion_guessed",
         phrase("Nothing told the motion at {} of {} observations, first at {} s: what was seen "
                "there has too little in common with what was seen before, or only goes along the "
                "way.",
                counts.guessed, counts.observations, formatNumber(counts.guessed_s)),
         phrase(
             "From there on the way may be off: give odometry, or drive more slowly where little "
             "is in sight.")});
  }
  if (counts.start_refuted) {
    warnings.push_back(
        {"began_elsewhere",
         phrase("The drive did not begin where it was said to: what the robot saw there is not "
                "what it had seen there before."),
         phrase(
             "Say with “Robot is here” where it was, or run the recording with another start.")});
  }
  if (auto moved = warningOfStart(outcome)) warnings.push_back(std::move(*moved));
  return warnings;
}

}  // namespace handmap
