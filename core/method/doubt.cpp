#include "core/method/doubt.h"

#include "core/map/certainty.h"
#include "core/map/concerns.h"
#include "core/method/constants.h"

namespace handmap {

using namespace method;

namespace {

double shareWrong(const Building& building, int concerns) {
  const double said = doubtOf(building);
  if (!isRecognised(building)) return said > 0.0 ? kProbablyWrong : 0.0;
  if (concerns > 1 || said >= kSlight) return kProbablyWrong;
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
