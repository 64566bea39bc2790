// What in a drawing is likely to be a slip, so that somebody can look at it. None of it keeps a map
// from being saved.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/map/map.h"

namespace handmap {

struct Issue {
  enum class Kind {
    NoBuilding,
    NoStart,
    StartInBuilding,    ///< ids: the building
    RouteInBuilding,    ///< ids: the building; `at` on the route
    RouteFarFromStart,  ///< `metres` from the start to where the route begins
    Overlap,            ///< ids: two buildings; `metres`²: the area they share
    CrossesItself,      ///< ids: a building whose outline does
    SameName,           ///< ids: a building or landmark and an earlier one of that name
    TooNarrow,          ///< ids: a building; `metres`: its narrower side
  };
  Kind kind;
  std::vector<std::string> ids;
  std::optional<Vec2> at;  ///< where to look
  double metres = 0.0;

  /// A run cannot work with it, or is likely to go wrong.
  bool isGrave() const { return kind <= Kind::StartInBuilding || kind == Kind::CrossesItself; }
};

inline constexpr std::size_t kMaxIssues = 1000;

/// In the order of the kinds, at most kMaxIssues. Throws Error when `stop` is requested.
std::vector<Issue> findIssues(const Map& map, const std::stop_token& stop = {});

/// One English line: "N1 and N2 overlap by 12.5 m²".
std::string inWords(const Issue& issue);

}  // namespace handmap
