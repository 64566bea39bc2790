#include "core/map/start_uncertainty.h"

#include <cmath>

#include "core/base/json.h"
#include "core/map/map_limits.h"

namespace handmap {

namespace {

/// What people type stays what they typed.
double thousandths(double value) { return std::round(value * 1000.0) / 1000.0; }

}  // namespace

std::optional<StartUncertainty> startUncertaintyOf(const UnknownMembers& members,
                                                   const std::string& source) {
  const auto member = members.find(kStartUncertaintyKey);
  if (member == members.end()) return std::nullopt;
  const auto parsed =
      parseJson("{\"" + std::string(kStartUncertaintyKey) + "\":" + member->second + "}", source);
  const JsonValue json = JsonValue(parsed, source).at(kStartUncertaintyKey).object();
  StartUncertainty uncertainty;
  if (const auto sigma = json.find("position_m")) {
    uncertainty.position = sigma->number(0.0, kMaxSigma);
  }
  if (const auto sigma = json.find("heading_deg")) {
    uncertainty.heading = toRadians(sigma->number(0.0, kMaxTurnSigmaDeg));
  }
  return uncertainty;
}

void setStartUncertainty(UnknownMembers& members,
                         const std::optional<StartUncertainty>& uncertainty) {
  if (!uncertainty) {
    members.erase(kStartUncertaintyKey);
    return;
  }
  const nlohmann::json json{{"position_m", thousandths(uncertainty->position)},
                            {"heading_deg", thousandths(toDegrees(uncertainty->heading))}};
  members[kStartUncertaintyKey] = json.dump();
}

}  // namespace handmap
