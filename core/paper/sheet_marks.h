// The marks of a printed sheet, and how a photo shows them.
//
// A mark is a black frame around white around black, of seven by seven cells; of the one at the
// top left the very middle is white, so that no turn can be taken for another.
#pragma once

#include <optional>

#include <opencv2/core/mat.hpp>

#include "core/geometry/polygon.h"
#include "core/paper/quad.h"
#include "core/paper/sheet.h"

namespace handmap {

inline constexpr int kMarkCells = 7;
inline constexpr double kMark_mm = 10.5;
/// Middles: top left, top right, bottom right, bottom left of the sheet.
std::array<Vec2, 4> markPlaces();

/// Cells between the two upper marks, left to right: the first is black, three for the square, one
/// for a map on it, one that makes the number of black ones odd.
inline constexpr int kCodeCells = 6;
inline constexpr double kCodeCell_mm = 5.0;
std::array<bool, kCodeCells> codeCells(const SheetCode& code);
Vec2 codePlace(int cell);  ///< its middle, mm
std::optional<SheetCode> codeOf(const std::array<bool, kCodeCells>& cells);

/// Beside it, half of them left and half right: the corner of a sheet with a map, 15 cells for x,
/// 15 for y, 8 that check them. All white: none.
inline constexpr int kPlaceCells = 38;
inline constexpr int kMostCornerSteps = (1 << 14) - 1;
std::array<bool, kPlaceCells> placeCells(const SheetCode& code);
Vec2 placeCellPlace(int cell);  ///< its middle, mm
std::optional<std::array<int, 2>> cornerOf(const std::array<bool, kPlaceCells>& cells);

struct SeenSheet {
  Quad grid;  ///< its corners on the photo
  SheetCode code;
};

/// nullopt where the photo shows no sheet whole.
std::optional<SeenSheet> sheetOn(const cv::Mat& photo);

}  // namespace handmap
