#include "drivers/virtual/faults.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

namespace {

constexpr std::array kKinds = {
    std::pair(FaultKind::Drop, "drop"),      std::pair(FaultKind::Late, "late"),
    std::pair(FaultKind::Unplug, "unplug"),  std::pair(FaultKind::Freeze, "freeze"),
    std::pair(FaultKind::Clock, "clock"),    std::pair(FaultKind::Double, "double"),
    std::pair(FaultKind::Half, "half"),      std::pair(FaultKind::Swap, "swap"),
    std::pair(FaultKind::Limit, "limit"),    std::pair(FaultKind::Echo, "echo"),
    std::pair(FaultKind::Verbose, "verbose")};
constexpr std::array kDevices = {DeviceRole::Odometry, DeviceRole::Scanner, DeviceRole::Camera,
                                 DeviceRole::Head};
constexpr double kMostSeconds = 1e6;

std::string kindsOf(VirtualRigKind rig) {
  std::string text;
  for (const DeviceRole role : kDevices) {
    std::string kinds;
    for (const auto& [of, kind] : possibleFaults(rig)) {
      if (of == role) kinds += fmt::format("{}{}", kinds.empty() ? "" : ", ", nameOf(kind));
    }
    if (!kinds.empty()) {
      text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", nameOf(role), kinds);
    }
  }
  return text;
}

[[noreturn]] void refuse(std::string_view fault, VirtualRigKind rig) {
  throw Error(ErrorCode::Usage,
              phrase("--faults: found \"{}\", expected DEVICE:KIND@BEGIN+SECONDS", fault),
              phrase("{}; e.g. {}", kindsOf(rig), "odometry:unplug@10+5,odometry:late@20+3"));
}

Fault parseFault(std::string_view text, VirtualRigKind rig) {
  const auto colon = text.find(':');
  const auto at = text.find('@');
  const auto plus = text.find('+');
  if (colon == std::string_view::npos || at == std::string_view::npos ||
      plus == std::string_view::npos || !(colon < at && at < plus)) {
    refuse(text, rig);
  }
  Fault fault;
  bool role_known = false;
  for (const DeviceRole role : kDevices) {
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
  if (!role_known || !kind_known || !times_fit) refuse(text, rig);
  const auto possible = possibleFaults(rig);
  if (std::find(possible.begin(), possible.end(), std::pair(fault.role, fault.kind)) ==
      possible.end()) {
    refuse(text, rig);
  }
  fault.begin_s = *begin;
  fault.end_s = *begin + *length;
  return fault;
}

}  // namespace

const char* nameOf(FaultKind kind) {
  for (const auto& [its, name] : kKinds) {
    if (its == kind) return name;
  }
  return "";
}

std::vector<std::pair<DeviceRole, FaultKind>> possibleFaults(VirtualRigKind kind) {
  std::vector<std::pair<DeviceRole, FaultKind>> possible;
  const auto add = [&possible](DeviceRole role, std::initializer_list<FaultKind> kinds) {
    for (const FaultKind its : kinds) possible.emplace_back(role, its);
  };
  using enum FaultKind;
  if (kind == VirtualRigKind::Laser) {
    add(DeviceRole::Odometry, {Drop, Late, Unplug, Freeze, Clock});
    add(DeviceRole::Scanner, {Drop, Late, Unplug, Freeze, Clock});
  } else {
    add(DeviceRole::Odometry, {Drop, Double, Late, Unplug, Freeze, Clock});
    add(DeviceRole::Camera, {Drop, Late, Unplug, Freeze, Half, Swap});
    add(DeviceRole::Head, {Drop, Double, Late, Unplug, Freeze, Limit, Echo, Verbose});
  }
  return possible;
}

std::vector<Fault> parseFaults(std::string_view text, VirtualRigKind kind) {
  std::vector<Fault> faults;
  if (trimmed(text).empty()) return faults;
  for (const std::string_view part : splitFields(text, ','))
    faults.push_back(parseFault(part, kind));
  return faults;
}

std::optional<FaultKind> faultAt(const std::vector<Fault>& faults, DeviceRole role, double now_s) {
  for (const Fault& fault : faults) {
    if (fault.role == role && now_s >= fault.begin_s && now_s < fault.end_s) return fault.kind;
  }
  return std::nullopt;
}

}  // namespace handmap
