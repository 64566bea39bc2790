// Whether what runs say of themselves is so: stated against true probability.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/experiments/report.h"

namespace handmap {

/// "It is so with this probability", and whether it was.
struct Statement {
  double stated = 0.0;
  bool so = false;
};

/// What one run stated.
struct RunStatements {
  std::string name;
  bool simulated = false;
  /// Live, that the pose is off by no more than method::kWithin_m; once in kStatementStep_m of way,
  /// since neighbouring poses are right or wrong together.
  std::array<std::vector<Statement>, method::kWithin_m.size()> pose;
  /// At the end, that a wall is off by no more than its σ: four of each building that was seen.
  std::vector<Statement> walls;
};

inline constexpr double kStatementStep_m = 5.0;

/// Runs to the end. The source needs truth; without `truth` there is nothing of walls. nullopt
/// where `stop` was requested. Throws BadInput for a source without truth.
std::optional<RunStatements> observeRun(const std::string& name, RunSession& session,
                                        const Map* truth, const std::stop_token& stop);

/// One of the simulated drives that the other experiments know.
std::optional<RunStatements> observeTrial(const TrialKey& key, const TrialSettings& settings,
                                          const std::stop_token& stop);

/// Tables and charts by ranges of what was stated, with Wilson's intervals; simulated and real
/// apart.
Report reliabilityReport(const std::vector<RunStatements>& runs);

}  // namespace handmap
