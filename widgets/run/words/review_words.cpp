#include "widgets/run/words/review_words.h"

#include <algorithm>
#include <cmath>

#include "core/map/certainty.h"
#include "widgets/run/words/words.h"

namespace handmap {

namespace {

constexpr double kConcernDegree = 0.5;  // of suspicion: to be looked at, not to be left out
constexpr double kUnseenDegree = 0.1;   // a building that nobody saw stays as it was drawn

}  // namespace

Suspicion ReviewWords::suspicion(const Map& drawing, const Map& refined, std::size_t building,
                                 std::span<const Concern> concerns) {
  const Building& now = refined.buildings[building];
  Suspicion found;
  for (const Concern& concern : concernsAbout(building, concerns)) {
    found.degree += kConcernDegree;
    found.reasons << Words::concern(concern, drawing);
  }
  if (!isRecognised(now)) {
    found.degree += kUnseenDegree;
    const bool carried = changeOf(drawing.buildings[building], now).moved_m() >= kLeastMove_m;
    found.reasons << (carried ? tr("not recognised: it moves with the others")
                              : tr("not recognised: it stays as drawn"));
  }
  if (const double doubt = doubtOf(now); doubt > 0.0) {
    found.degree += 2.0 * doubt;  // 1 where either is as likely
    found.reasons << tr("wrong in about %1 of 100 such cases").arg(std::lround(100.0 * doubt));
  }
  if (!isRecognised(now)) return found;
  const std::vector<SideEstimate> walls = wallsOf(now);
  const auto seen = std::ranges::count_if(walls, &SideEstimate::seen);
  if (const auto all = static_cast<long>(walls.size()); seen < all) {
    found.degree += kUnseenDegree * static_cast<double>(all - seen) / static_cast<double>(all);
    found.reasons << tr("%1 of %2 walls seen").arg(seen).arg(all);
  }
  return found;
}

std::optional<double> seenSigma(const Building& now) {
  std::optional<double> worst;
  if (!isRecognised(now)) return worst;
  for (const SideEstimate& wall : wallsOf(now))
    if (wall.seen) worst = std::max(worst.value_or(0.0), wall.sigma);
  return worst;
}

}  // namespace handmap
