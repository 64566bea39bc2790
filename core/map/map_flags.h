// What is noted of single objects of a drawing. Kept in the file as members of our own
// ("handmap:hidden": true), so that other readers need not know them.
#pragma once

#include "core/map/map.h"

namespace handmap {

inline constexpr auto kHiddenKey = "handmap:hidden";
inline constexpr auto kLockedKey = "handmap:locked";

inline constexpr auto kMayNotExistKey = "handmap:may_not_exist";

inline bool hasFlag(const UnknownMembers& members, const char* key) {
  if (members.empty()) return false;
  const auto found = members.find(key);
  return found != members.end() && found->second == "true";
}

inline void setFlag(UnknownMembers& members, const char* key, bool on) {
  if (on)
    members[key] = "true";
  else
    members.erase(key);
}

/// Not drawn and not met by the pointer. Item: a building, landmark or underlay.
template <typename Item>
bool isHidden(const Item& item) {
  return hasFlag(item.unknown, kHiddenKey);
}

/// Not changed by the pointer on the canvas.
template <typename Item>
bool isLocked(const Item& item) {
  return hasFlag(item.unknown, kLockedKey);
}

/// Whoever drew it is not sure that it is there at all. The only one of them that a run looks at.
inline bool mayNotExist(const Building& building) {
  return hasFlag(building.unknown, kMayNotExistKey);
}

}  // namespace handmap
