#include "core/method/doubt.h"

#include "core/map/certainty.h"
#include "core/map/concerns.h"
#include "core/method/constants.h"

namespace handmap {

using namespace method;

namespace {

bool isDoubtful(const Building& building, bool concerns) {
  const double said = doubtOf(building);
  return isRecognised(building) ? concerns || said >= kSlight : said > 0.0;
}

}  // namespace

void stateDoubt(const Map& drawing, Map& refined) {
  std::vector<bool> concerns(refined.buildings.size());
  for (const Concern& concern : concernsOf(drawing, refined)) concerns[concern.building] = true;
  for (std::size_t b = 0; b < refined.buildings.size(); ++b) {
    Building& building = refined.buildings[b];
    if (drawing.buildings[b].fixed) continue;
    const bool doubtful = isDoubtful(building, concerns[b]);
    building.doubt.reset();
    if (doubtful) setDoubt(building, kProbablyWrong);
  }
}

}  // namespace handmap
