// A run in one file that anybody can open: plan, certainty, table, what went wrong. As HTML with a
// timeline, pictures and the data itself, which refers to nothing outside; as PDF to be printed.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/map/map.h"
#include "core/recording/recording.h"

namespace handmap {

/// One wall of the corrected map.
struct WallTolerance {
  std::string building;
  int side = 0;  ///< of its box(), as Sides has them
  double sigma = 0.0;
  bool seen = false;
  /// Probability that it is off by no more than kTolerances_m, its building being right or not.
  std::array<double, 3> within{};
};

/// The classes in which surveyors state base maps, metres.
inline constexpr std::array<double, 3> kTolerances_m = {0.3, 0.6, 1.2};

/// Of the buildings that have an estimate. `refined`: of a run on `drawing`.
std::vector<WallTolerance> tolerancesOf(const Map& drawing, const Map& refined);

/// How far the middle of a wall is off, metres across the true one. `side` is of the box() of
/// `found`, as Sides has them; the true building's heading may be quarters off.
double wallOffset(const Building& found, const Building& truth, int side);

/// What surveyors of base maps state where the truth is known.
struct Survey {
  int buildings = 0;  ///< of the truth
  int present = 0;    ///< of them on the corrected map, so that the two overlap
  int walls = 0;      ///< of the map that were seen and whose building is drawn and true
  double rms_before_m = 0.0;
  double rms_after_m = 0.0;
  std::array<int, 3> within_before{};  ///< walls, by kTolerances_m
  std::array<int, 3> within_after{};
};
Survey surveyOf(const Map& drawing, const Map& refined, const Map& truth);

/// Of what is printed; the page has both.
enum class ReportLanguage { English, Japanese };

/// Where the robot may have been at a time.
struct ReportedParticles {
  double time_s = 0.0;
  std::vector<Vec2> points;
};

struct ReportInputs {
  Map drawing;
  Map refined;
  std::string run;       ///< what run --report wrote
  std::string run_file;  ///< its name, for messages
  std::vector<StampedPose> trajectory = {};
  std::vector<ReportedParticles> particles = {};  ///< in the order of their times
  std::optional<Map> truth = {};
  std::optional<Recording> recording = {};  ///< for pictures on the way
  ReportLanguage language = ReportLanguage::English;
};

/// Throws BadInput where the report of the run is none.
std::string reportHtml(const ReportInputs& inputs);
/// Pages of A4; throws alike.
std::string reportPdf(const ReportInputs& inputs);
/// A row a wall, with a header below lines ("# …") that say what each column means.
std::string tolerancesCsv(const Map& drawing, const Map& refined);
/// The same as a LaTeX table, with a word on what each column means.
std::string tolerancesLatex(const Map& drawing, const Map& refined);

}  // namespace handmap
