// What a person looks at before a correction is taken over: how much a building changes and what
// makes that doubtful.
#pragma once

#include <QCoreApplication>
#include <QStringList>
#include <span>

#include "core/map/concerns.h"

namespace handmap {

/// What is doubtful about a corrected building.
struct Suspicion {
  double degree = 0.0;  ///< for sorting: 0 nothing; 1 and more: rather not right
  QStringList reasons;  ///< the gravest first
};

class ReviewWords {
  Q_DECLARE_TR_FUNCTIONS(handmap::ReviewWords)
 public:
  /// `refined`: of a run on `drawing`; `concerns`: of both.
  static Suspicion suspicion(const Map& drawing, const Map& refined, std::size_t building,
                             std::span<const Concern> concerns);
};

/// The worst σ of the walls that were seen, metres; nullopt: none was.
std::optional<double> seenSigma(const Building& now);

}  // namespace handmap
