// What the tools draw on the canvas: outlines, handles and sizes.
#pragma once

#include <QString>
#include <span>

#include "widgets/canvas/tool.h"
#include "widgets/style/colours.h"

namespace handmap {

void paintHandle(ToolPaint& canvas, const Vec2& position, bool round = false);
/// The box of a building with all its handles that have room.
void paintHandles(ToolPaint& canvas, const Rectangle& box);
void paintOutline(ToolPaint& canvas, std::span<const Vec2> points, bool closed, Role role);
/// Width and depth in metres along two sides of the box.
void paintSizes(ToolPaint& canvas, const Rectangle& box);
/// A line of text on a box of its own, readable on everything.
void paintNote(ToolPaint& canvas, const QPointF& centre, const QString& text);

QString metresText(double metres);           ///< "12.5 m"
QString degreesText(double heading_rad);     ///< "-30.5°"
QString positionText(const Vec2& position);  ///< "3.25, -1.50 m"

}  // namespace handmap
