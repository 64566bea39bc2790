// The map: what a person draws and what a run corrects. Map frame: x right, y up, metres.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/map/layers.h"

namespace handmap {

/// Members of a file that this version does not know: key → JSON text, kept and written back.
using UnknownMembers = std::map<std::string, std::string>;

/// How wrong the drawing may be, one σ, metres.
struct Uncertainty {
  double position = 3.0;
  double size = 3.0;
  bool operator==(const Uncertainty&) const = default;
};

/// What drawings from memory are off as a whole, one σ.
inline constexpr double kUsualScaleSigma = 0.05;
inline constexpr double kUsualTurnSigma = toRadians(1.0);
/// The same of the shift, as a share of the uncertainty of a building; choice.
inline constexpr double kUsualShiftShare = 0.3;

/// How wrong the whole drawing may be, one σ: scale (a share), turn (radians) and shift (metres, x
/// and y each). 0 where it was made over an aerial picture or from a public map, whose shift is
/// that of the picture; absent: as people draw.
struct WholeUncertainty {
  std::optional<double> scale;
  std::optional<double> turn;
  std::optional<double> shift = {};
  bool operator==(const WholeUncertainty&) const = default;
};

/// How sure the drawer is of where the robot starts, one σ.
struct StartUncertainty {
  double position = 0.0;  ///< of x and of y, metres
  double heading = 0.0;   ///< radians
  bool operator==(const StartUncertainty&) const = default;
};

/// Of a single object of a drawing.
struct Flags {
  bool hidden = false;  ///< not drawn and not met by the pointer
  bool locked = false;  ///< not moved, resized or deleted by hand; a run goes by `fixed`
  bool operator==(const Flags&) const = default;
};

/// How sure one side of a building is, across it.
struct SideEstimate {
  double sigma = 0.0;  ///< metres
  bool seen = false;   ///< false: it stands where the drawing has it from the other sides
  bool operator==(const SideEstimate&) const = default;
};

/// Side k of a box() has the outward normal heading + k · π/2.
using Sides = std::array<SideEstimate, 4>;

/// What a run found out about a building: σ in metres and how many observations it rests on.
struct Estimate {
  double sigma_x = 0.0;
  double sigma_y = 0.0;
  double sigma_width = 0.0;
  int observations = 0;
  bool operator==(const Estimate&) const = default;
};

struct Building {
  std::string id;  ///< unique in a map
  std::string name;
  std::variant<Rectangle, Polygon> shape;  ///< polygons are simple, counter-clockwise
  std::optional<Uncertainty> uncertainty;  ///< absent: that of the map
  bool fixed = false;                      ///< a run must not move it
  /// Whoever drew it is not sure that it is there at all: an even bet for a run.
  bool may_not_exist = false;
  Flags flags;
  std::optional<Estimate> estimate;
  std::optional<Sides> sides;  ///< as a run told them one by one; see sidesOf()
  /// Of an outline with other than four walls: those of its seen sides that were seen themselves.
  /// Empty: all of them; see wallsOf().
  std::vector<bool> seen_walls;
  std::optional<double> doubt;  ///< that it is another building or is not there, 0 … 1
  UnknownMembers unknown;

  Polygon footprint() const;
  /// Rectangle: itself. Polygon: its smallest bounding rectangle along one of its walls.
  Rectangle box() const;
  /// The same building with its box() moved and stretched to `target` (heading may turn too).
  /// Rectangles become the target; polygons move, turn and stretch as a whole.
  Building fitted(const Rectangle& target) const;
  bool operator==(const Building&) const = default;
};

struct Landmark {
  std::string id;
  std::string name;
  Vec2 position = Vec2::Zero();
  Flags flags = {};
  UnknownMembers unknown = {};
  bool operator==(const Landmark&) const = default;
};

/// A picture to draw upon. Its top left corner lies at x, y; it turns about that corner.
struct Underlay {
  std::string image;  ///< path, relative to the folder of the map
  double x = 0.0;
  double y = 0.0;
  double metres_per_pixel = 1.0;
  double heading = 0.0;  ///< radians
  double opacity = 1.0;  ///< 0 … 1
  Flags flags = {};
  UnknownMembers unknown = {};
  bool operator==(const Underlay&) const = default;
};

/// WGS 84 position of the map's origin, degrees, and the heading of the map's x axis
/// counter-clockwise from east, radians.
struct Georeference {
  double latitude = 0.0;
  double longitude = 0.0;
  double heading = 0.0;
  UnknownMembers unknown;
  bool operator==(const Georeference&) const = default;
};

struct Map {
  std::string name;
  std::optional<Pose2> start;                         ///< absent: unknown
  std::optional<StartUncertainty> start_uncertainty;  ///< absent: not said
  Uncertainty uncertainty;
  WholeUncertainty whole;
  std::vector<Building> buildings;
  std::vector<Landmark> landmarks;
  std::vector<Vec2> route;
  std::vector<Underlay> underlays;
  std::optional<Georeference> georeference;
  LayerStates layers;
  /// The taught building model that belongs to the map: a path, absolute or relative to the map's
  /// folder; empty: none.
  std::string model;
  std::string refinement;  ///< JSON object text: how a run made this map; empty for a drawing
  UnknownMembers unknown;

  const Building* find(const std::string& id) const;
  /// What a run goes by. Whatever is stated, it is no less than that of a fixed building: a σ of 0
  /// would leave nothing to weigh it against.
  Uncertainty uncertaintyOf(const Building& building) const;
  /// How far all of it may be off together, one σ, metres.
  double shiftSigma() const;
  bool operator==(const Map&) const = default;
};

/// Throws BadInput for a drawing in which no robot can be localized: no buildings, or no start.
void requireReadyToRun(const Map& drawing);

}  // namespace handmap
