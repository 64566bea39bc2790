#include "core/method/doubt.h"

#include "core/map/certainty.h"
#include "core/map/concerns.h"

namespace handmap {

namespace {

// Shares of buildings that were wrong (overlap with the true one below 0.3, or a larger one with
// another) among those of which the same was said, in 114 runs to the middle and to the end:
// campus, corner and street with all their drawings, far rows, the laser of another simulator, and
// five simulated scenes. Of 1,017 of which nothing was said 13 were wrong.
constexpr double kNotRecognised = 0.4;  // 36 of 88, as many where labels were sure as where not
constexpr double kOneConcern = 0.25;    // 14 of 57
constexpr double kMoreConcerns = 0.4;   // 10 of 24
/// What labels say of a building that was recognised: of those below this none of 9 was wrong, both
/// above were, which are too few for a figure of their own.
constexpr double kSlight = 0.3;

double shareWrong(const Building& building, int concerns) {
  const double said = doubtOf(building);
  if (!isRecognised(building)) return said > 0.0 ? kNotRecognised : 0.0;
  if (concerns > 1 || said >= kSlight) return kMoreConcerns;
  return concerns == 1 ? kOneConcern : 0.0;
}

}  // namespace

void stateDoubt(const Map& drawing, Map& refined) {
  std::vector<int> concerns(refined.buildings.size());
  for (const Concern& concern : concernsOf(drawing, refined)) ++concerns[concern.building];
  for (std::size_t b = 0; b < refined.buildings.size(); ++b) {
    Building& building = refined.buildings[b];
    if (drawing.buildings[b].fixed) continue;
    const double doubt = shareWrong(building, concerns[b]);
    building.doubt.reset();
    if (doubt > 0.0) setDoubt(building, doubt);
  }
}

}  // namespace handmap
