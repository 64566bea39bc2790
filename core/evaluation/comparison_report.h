// The tables of a comparison, for people and for programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/evaluation/comparison.h"

namespace handmap {

struct ComparisonReport {
  MapComparison as_it_is;
  MapComparison aligned;
  std::optional<TrajectoryError> trajectory;
  std::vector<std::string> only;  ///< ids of the buildings to tell about; empty: all
};

/// Markdown tables: a row a building and the means of the absolute errors. Metres and degrees.
std::string formatText(const ComparisonReport& report);
/// The same numbers unrounded, as JSON; angles in radians.
std::string formatJson(const ComparisonReport& report);

}  // namespace handmap
