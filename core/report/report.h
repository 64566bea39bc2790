// A run in one file that anybody can open: plan, certainty, table, what went wrong. As HTML with a
// timeline, pictures and the data itself, which refers to nothing outside; as PDF to be printed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/map/map.h"
#include "core/recording/recording.h"

namespace handmap {

/// One wall of the corrected map.
struct WallTolerance {
  std::string building;
  int side = 0;  ///< of its box(), from 0
  double sigma = 0.0;
  bool seen = false;
  /// Probability that it is off by no more than kTolerances_m, its building being right or not.
  std::array<double, 3> within{};
};

/// The classes in which surveyors state base maps, metres.
inline constexpr std::array<double, 3> kTolerances_m = {0.3, 0.6, 1.2};

/// Of the buildings that have an estimate.
std::vector<WallTolerance> tolerancesOf(const Map& refined);

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
/// A row a wall, with a header.
std::string tolerancesCsv(const Map& refined);
/// The same as a LaTeX table, with a word on what each column means.
std::string tolerancesLatex(const Map& refined);

}  // namespace handmap
