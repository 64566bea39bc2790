// What a run has changed in a drawing, building by building.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/map/map.h"

namespace handmap {

// Less is not a change that anybody sees.
inline constexpr double kLeastMove_m = 0.1;
inline constexpr double kLeastTurn = toRadians(2.0);
inline constexpr double kLeastGrowth_m = 0.5;  ///< of one of the sizes

struct BuildingChange {
  std::size_t building = 0;   ///< of the drawing
  Vec2 drawn = Vec2::Zero();  ///< middle of its area, metres
  Vec2 now = Vec2::Zero();
  double turned = 0.0;     ///< counter-clockwise, radians
  double wider_m = 0.0;    ///< along the heading of the drawn box; negative: shrunk
  double deeper_m = 0.0;   ///< across it
  double doubt = 0.0;      ///< see doubtOf()
  bool one_sided = false;  ///< one side alone was seen: how deep it is behind that is as drawn
  double moved_m() const { return (now - drawn).norm(); }
  /// The size that changed most, with its sign.
  double grown_m() const;
  bool isTurned() const;
  bool isResized() const;
};

/// `now`: the building that a run made of `drawn`.
BuildingChange changeOf(const Building& drawn, const Building& now);

struct MapChanges {
  std::vector<BuildingChange> moved;      ///< and seen; the farthest first
  std::vector<BuildingChange> kept;       ///< seen and neither moved, turned nor resized, or fixed
  std::vector<BuildingChange> unseen;     ///< no observation stands for them
  std::vector<BuildingChange> turned;     ///< of those seen; the most turned first
  std::vector<BuildingChange> resized;    ///< of those seen; the most changed first
  std::vector<BuildingChange> one_sided;  ///< of those seen
  std::vector<BuildingChange> doubtful;   ///< also among the others; the most doubtful first
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
