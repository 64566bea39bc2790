// The one table of what a colour means, on the canvas, in charts, tables, legends and exports.
// Never colour alone: each role has a line style or a pattern too. Blue, orange and green are those
// of Okabe and Ito, told apart by colour-blind eyes.
#pragma once

#include <QBrush>
#include <QColor>
#include <QPen>

class QPalette;

namespace handmap {

enum class Role {
  Background,
  GridLine,
  GridLineMajor,
  Axis,
  Text,      ///< labels on the canvas
  TextHalo,  ///< behind them
  Drawing,   ///< ink: solid grey-black
  Selection,
  Preview,        ///< what a tool is making
  Problem,        ///< what a tool refuses
  Corrected,      ///< the corrected map: solid blue
  CorrectedBand,  ///< its one-sigma band: translucent blue
  Swarm,          ///< samples of its buildings: thin pale blue
  Truth,          ///< dashed green
  Particle,       ///< orange, see particle()
  Trajectory,     ///< of the best particle: solid orange
  Odometry,       ///< dotted grey
  LocalMap,       ///< cells of walls seen
  Doubtful,       ///< hatched
  Start,
  Route,  ///< dash-dotted
  Landmark,
  Count
};

/// As wide on screens with finer pixels, whatever the scale of the map.
QPen cosmeticPen(const QColor& colour, double width_px);

class Colours {
 public:
  static const Colours& light();
  static const Colours& dark();
  static const Colours& of(const QPalette& palette);

  QColor operator[](Role role) const;
  QPen pen(Role role) const;  ///< cosmetic, in the role's width and line style
  /// Under a line that may lie on a picture.
  QPen casing(const QPen& line) const;
  QBrush brush(Role role) const;  ///< the role's translucent fill or pattern; NoBrush without one
  /// `share` = weight / greatest weight, 0 … 1: the surer, the stronger.
  QColor particle(double share) const;

 private:
  explicit Colours(bool dark) : dark_(dark) {}

  bool dark_;
};

}  // namespace handmap
