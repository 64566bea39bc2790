#include "drivers/virtual/faults.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"

namespace handmap {

namespace {

constexpr std::array kKinds = {
    std::pair(FaultKind::Drop, "drop"), std::pair(FaultKind::Late, "late"),
    std::pair(FaultKind::Unplug, "unplug"), std::pair(FaultKind::Freeze, "freeze"),
    std::pair(FaultKind::Clock, "clock")};
constexpr std::array kSensors = {DeviceRole::Odometry, DeviceRole::Scanner, DeviceRole::Camera};
constexpr double kMostSeconds = 1e6;

[[noreturn]] void refuse(std::string_view fault) {
  throw Error(ErrorCode::Usage,
              fmt::format("--faults: found \"{}\", expected DEVICE:KIND@BEGIN+SECONDS", fault),
              "DEVICE: odometry, scanner or camera; KIND: drop, late, unplug, freeze or clock; "
              "e.g. scanner:unplug@10+5,odometry:late@20+3");
}

Fault parseFault(std::string_view text) {
  const auto colon = text.find(':');
  const auto at = text.find('@');
  const auto plus = text.find('+');
  if (colon == std::string_view::npos || at == std::string_view::npos ||
      plus == std::string_view::npos || !(colon < at && at < plus)) {
    refuse(text);
  }
  Fault fault;
  bool role_known = false;
  for (const DeviceRole role : kSensors) {
    if (text.substr(0, colon) != nameOf(role)) continue;
    fault.role = role;
    role_known = true;
  }
  bool kind_known = false;
  for (const auto& [kind, name] : kKinds) {
    if (text.substr(colon + 1, at - colon - 1) != name) continue;
    fault.kind = kind;
    kind_known = true;
  }
  const auto begin = parseFinite(text.substr(at + 1, plus - at - 1));
  const auto length = parseFinite(text.substr(plus + 1));
  const bool times_fit = begin && length && *begin >= 0.0 && *begin <= kMostSeconds &&
                         *length > 0.0 && *length <= kMostSeconds;
  if (!role_known || !kind_known || !times_fit) refuse(text);
  fault.begin_s = *begin;
  fault.end_s = *begin + *length;
  return fault;
}

}  // namespace

std::vector<Fault> parseFaults(std::string_view text) {
  std::vector<Fault> faults;
  if (trimmed(text).empty()) return faults;
  for (const std::string_view part : splitFields(text, ',')) faults.push_back(parseFault(part));
  return faults;
}

std::optional<FaultKind> faultAt(const std::vector<Fault>& faults, DeviceRole role, double now_s) {
  for (const Fault& fault : faults) {
    if (fault.role == role && now_s >= fault.begin_s && now_s < fault.end_s) return fault.kind;
  }
  return std::nullopt;
}

}  // namespace handmap
