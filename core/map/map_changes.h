// What a run has changed in a drawing, building by building.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/map/map.h"

namespace handmap {

struct BuildingChange {
  std::size_t building;  ///< of the drawing
  Vec2 drawn;            ///< middle of its area, metres
  Vec2 now;
  double doubt;  ///< see doubtOf()
  double moved_m() const { return (now - drawn).norm(); }
};

/// Less is not a change that anybody sees.
inline constexpr double kLeastMove_m = 0.1;

struct MapChanges {
  std::vector<BuildingChange> moved;     ///< and seen; the farthest first
  std::vector<BuildingChange> kept;      ///< seen, and less than kLeastMove_m off
  std::vector<BuildingChange> unseen;    ///< no observation stands for them
  std::vector<BuildingChange> doubtful;  ///< also among the others; the most doubtful first
};

/// `refined`: of a run on `drawing`, its buildings in the same order.
MapChanges changesOf(const Map& drawing, const Map& refined);

/// The true middles of buildings, by their ids.
class TrueMiddles {
 public:
  explicit TrueMiddles(const Map& truth);
  /// Metres from the middle of the building to the true one of the same id. nullopt: there is none.
  std::optional<double> errorOf(const Building& building) const;

 private:
  std::unordered_map<std::string, Vec2> middles_;
};

}  // namespace handmap
