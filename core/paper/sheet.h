// The printed sheet: a light grid to draw on, between marks by which a photo of it is straightened.
//
// Places on it are millimetres, x right, y up, from the lower left corner of the grid. How it is
// printed (A4, Letter, made smaller to fit) does not matter: what is a metre is told by a code
// between the marks.
#pragma once

#include <array>
#include <optional>
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

/// Of the corner of a sheet that a map is printed on, a square.
inline constexpr int kCornerSteps = 5;

/// What a sheet tells of itself.
struct SheetCode {
  double square_m = 10.0;  ///< one of kSquares_m
  bool of_map = false;     ///< a map is printed on it: its start need not be at the usual place
  /// Of one with a map, where its lower left is on that, x and y, in steps of 1 / kCornerSteps
  /// squares; nullopt: too far from the origin to be told.
  std::optional<std::array<int, 2>> corner = {};
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
Sheet emptySheet(const SheetCode& code);
/// That of a photo; nullopt: a map is printed on it, and it does not tell where. The start of one
/// with a map is not told.
std::optional<Sheet> sheetOf(const SheetCode& code);
/// The one that the map was drawn on, if all of it is there; else one with all of the map in its
/// middle. Throws BadInput as above.
Sheet sheetFor(const Map& map);

/// Of the underlay that is the page: "true", or of a printed sheet {"square_m": …}.
inline constexpr auto kPaperKey = "handmap:paper";
/// The sheet that lies under the map as its page.
std::optional<Sheet> sheetUnder(const Map& map);

/// What is printed, in the order to print it.
struct SheetPart {
  Polygon line;           ///< mm; filled, or closed and drawn
  double darkness = 1.0;  ///< 0 white … 1 black
  double width_mm = 0.0;  ///< 0: filled
};

/// A name, its middle at `at`.
struct SheetName {
  Vec2 at;  ///< mm
  double size_mm = 0.0;
  std::string text;
};

/// Marks, code, grid, scale bar, north, arrow; and the outlines of the map's buildings.
std::vector<SheetPart> sheetParts(const Sheet& sheet, const Map* map = nullptr);
/// The outlines alone.
std::vector<SheetPart> outlineParts(const Sheet& sheet, const Map& map);
/// Of the buildings that have one, as dark as the outlines.
std::vector<SheetName> sheetNames(const Sheet& sheet, const Map& map);
/// Parts and names as a page of A4, with the length of the scale bar.
std::string sheetPdf(const Sheet& sheet, const Map* map = nullptr);
/// Outlines and names alone, to be printed on the paper that the map was drawn on. Throws BadInput
/// where no sheet is under the map.
std::string overprintPdf(const Map& map);

}  // namespace handmap
