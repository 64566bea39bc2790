// The printed sheet: a light grid to draw on, between marks by which a photo of it is straightened.
//
// Places on it are millimetres, x right, y up, from the lower left corner of the grid. How it is
// printed (A4, Letter, made smaller to fit) does not matter: what is a metre is told by a code
// between the marks.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/map/map.h"

namespace handmap {

inline constexpr double kSheetSquare_mm = 10.0;
inline constexpr double kSheetWidth_mm = 24 * kSheetSquare_mm;
inline constexpr double kSheetHeight_mm = 16 * kSheetSquare_mm;

/// Metres of a square of the grid; the code tells which.
inline constexpr std::array<double, 8> kSquares_m = {1, 2, 5, 10, 20, 50, 100, 200};

/// Of what is printed on the grid, 0 white … 1 black: a pencil is darker.
inline constexpr double kDarkestPrint = 0.2;

/// What a sheet tells of itself.
struct SheetCode {
  double square_m = 10.0;  ///< one of kSquares_m
  bool of_map = false;     ///< a map is printed on it: its start need not be at the usual place
  bool operator==(const SheetCode&) const = default;
};

/// Where a sheet lies on the map.
struct Sheet {
  SheetCode code;
  Vec2 corner = Vec2::Zero();  ///< lower left of the grid, metres of the map
  Pose2 start;                 ///< what its arrow shows, map frame

  Vec2 toMap(const Vec2& place_mm) const { return corner + metres_per_mm() * place_mm; }
  Vec2 toPaper(const Vec2& point) const { return (point - corner) / metres_per_mm(); }
  double metres_per_mm() const { return code.square_m / kSheetSquare_mm; }
};

/// An empty one for a place of that width: the robot starts at the origin, which is below the
/// middle, and looks up the sheet. Throws BadInput for a place that no sheet can hold.
Sheet emptySheet(double width_m);
/// The same of a photo of an empty sheet.
Sheet emptySheet(const SheetCode& code);
/// One with all of the map in its middle. Throws BadInput as above.
Sheet sheetFor(const Map& map);

/// What is printed, in the order to print it.
struct SheetPart {
  Polygon line;           ///< mm; filled, or closed and drawn
  double darkness = 1.0;  ///< 0 white … 1 black
  double width_mm = 0.0;  ///< 0: filled
};

/// Marks, code, grid, scale bar, north, arrow; and the outlines of the map's buildings.
std::vector<SheetPart> sheetParts(const Sheet& sheet, const Map* map = nullptr);
/// The same as a page of A4, with the length of the scale bar.
std::string sheetPdf(const Sheet& sheet, const Map* map = nullptr);

}  // namespace handmap
