// Draws the pointer to what is drawn around it, and says to what.
#pragma once

#include "widgets/canvas/tool.h"

namespace handmap {

class CanvasSnapping {
 public:
  static constexpr double kGridStep = 0.5;  ///< metres

  explicit CanvasSnapping(const MapDocument& document) : document_(document) {}

  SnapModes modes() const { return modes_; }
  void setModes(SnapModes modes) { modes_ = modes; }
  /// Objects, grid, both, neither, and again.
  void cycle();
  QString modeName() const;

  /// `context`: nothing, or held off: the pointer is only rounded to the grid or the centimetre.
  Snap snap(const Vec2& pointer, double reach, const std::optional<SnapContext>& context,
            bool held_off) const;

 private:
  std::vector<Segment> wallsAround(const SnapContext& context, const Vec2& pointer,
                                   double reach) const;

  const MapDocument& document_;
  SnapModes modes_;
};

/// A sign at the point, the lines that it lies on, and what they are in a word.
void paintSnap(ToolPaint& canvas, const Snap& snap);

}  // namespace handmap
