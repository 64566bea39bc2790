#include "core/paper/sheet.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/paper/sheet_marks.h"
#include "core/pdf/pdf_document.h"

namespace handmap {

namespace {

constexpr double kGridDark = 0.12;
constexpr double kArrowDark = 0.14;
Vec2 arrowAt() { return {kSheetWidth_mm / 2.0, 2.0 * kSheetSquare_mm}; }
constexpr double kBarY_mm = -9.0;  // below the grid
constexpr int kBarSquares = 5;

Polygon boxAround(const Vec2& middle, double width, double height) {
  return Rectangle{middle, width, height, 0.0}.corners();
}

/// The least square of which so many metres fit.
double squareFor(double width_m, double height_m) {
  for (const double square_m : kSquares_m) {
    const double metres_per_mm = square_m / kSheetSquare_mm;
    if (width_m <= kSheetWidth_mm * metres_per_mm && height_m <= kSheetHeight_mm * metres_per_mm)
      return square_m;
  }
  throwBadInput(
      phrase("the sheet"), "",
      phrase("{} × {} m", formatNumber(std::round(width_m)), formatNumber(std::round(height_m))),
      phrase("at most 4800 × 3200 m"));
}

void addMark(std::vector<SheetPart>& parts, const Vec2& middle, bool first) {
  const double cell = kMark_mm / kMarkCells;
  parts.push_back({boxAround(middle, 7 * cell, 7 * cell), 1.0, 0.0});
  parts.push_back({boxAround(middle, 5 * cell, 5 * cell), 0.0, 0.0});
  parts.push_back({boxAround(middle, 3 * cell, 3 * cell), 1.0, 0.0});
  if (first) parts.push_back({boxAround(middle, cell, cell), 0.0, 0.0});
}

void addScale(std::vector<SheetPart>& parts) {
  const double x = kSheetWidth_mm / 2.0 - kBarSquares * kSheetSquare_mm / 2.0;
  for (int i = 0; i < kBarSquares; ++i) {
    const Polygon box =
        boxAround({x + (i + 0.5) * kSheetSquare_mm, kBarY_mm}, kSheetSquare_mm, 2.5);
    if (i % 2 == 0) parts.push_back({box, 1.0, 0.0});
    parts.push_back({box, 1.0, 0.2});
  }
}

void addArrow(std::vector<SheetPart>& parts, const Pose2& pose_mm) {
  constexpr double kSize = 0.9 * kSheetSquare_mm;
  Polygon arrow;
  for (const Vec2& p : {Vec2(1.0, 0.0), Vec2(-0.5, 0.5), Vec2(-0.2, 0.0), Vec2(-0.5, -0.5)})
    arrow.push_back(pose_mm.toOuter(kSize * p));
  parts.push_back({arrow, kArrowDark, 0.0});
}

void addGrid(std::vector<SheetPart>& parts) {
  const auto line = [&](const Vec2& a, const Vec2& b) {
    parts.push_back({{a, b}, kGridDark, 0.2});
  };
  for (double x = 0.0; x <= kSheetWidth_mm; x += kSheetSquare_mm)
    line({x, 0.0}, {x, kSheetHeight_mm});
  for (double y = 0.0; y <= kSheetHeight_mm; y += kSheetSquare_mm)
    line({0.0, y}, {kSheetWidth_mm, y});
}

}  // namespace

Sheet emptySheet(double width_m) { return emptySheet(SheetCode{squareFor(width_m, 0.0), false}); }

Sheet emptySheet(const SheetCode& code) {
  Sheet sheet;
  sheet.code = code;
  sheet.corner = -sheet.metres_per_mm() * arrowAt();
  sheet.start = Pose2{0.0, 0.0, kPi / 2.0};
  return sheet;
}

Sheet sheetFor(const Map& map) {
  Polygon points = map.route;
  for (const Building& building : map.buildings) {
    const Polygon outline = building.footprint();
    points.insert(points.end(), outline.begin(), outline.end());
  }
  if (map.start) points.push_back(map.start->position());
  if (points.empty()) return emptySheet(SheetCode{});
  const Bounds bounds = boundsOf(points);
  const Vec2 size = bounds.high - bounds.low;
  Sheet sheet;
  sheet.code = {squareFor(size.x(), size.y()), true};
  sheet.corner = (bounds.low + bounds.high) / 2.0 -
                 sheet.metres_per_mm() * Vec2(kSheetWidth_mm, kSheetHeight_mm) / 2.0;
  sheet.start = map.start.value_or(Pose2{0.0, 0.0, kPi / 2.0});
  return sheet;
}

std::vector<SheetPart> sheetParts(const Sheet& sheet, const Map* map) {
  std::vector<SheetPart> parts;
  addGrid(parts);
  if (!map || map->start) {
    const Vec2 at = sheet.toPaper(sheet.start.position());
    addArrow(parts, Pose2{at.x(), at.y(), sheet.start.heading});
  }
  if (map) {
    for (const Building& building : map->buildings) {
      Polygon outline = building.footprint();
      for (Vec2& corner : outline) corner = sheet.toPaper(corner);
      parts.push_back({outline, kDarkestPrint, 0.5});
    }
  }
  const auto places = markPlaces();
  for (std::size_t i = 0; i < places.size(); ++i) addMark(parts, places[i], i == 0);
  const auto cells = codeCells(sheet.code);
  for (int i = 0; i < kCodeCells; ++i) {
    if (cells[static_cast<std::size_t>(i)])
      parts.push_back({boxAround(codePlace(i), kCodeCell_mm, kCodeCell_mm), 1.0, 0.0});
  }
  addScale(parts);
  return parts;
}

std::string sheetPdf(const Sheet& sheet, const Map* map) {
  constexpr double kA4Width_mm = 297.0, kA4Height_mm = 210.0;
  PdfDocument pdf(kA4Width_mm, kA4Height_mm);
  pdf.beginPage();
  const Vec2 corner(0.5 * (kA4Width_mm - kSheetWidth_mm), 0.5 * (kA4Height_mm - kSheetHeight_mm));
  for (SheetPart part : sheetParts(sheet, map)) {
    for (Vec2& point : part.line) point += corner;
    const double grey = 1.0 - part.darkness;
    if (part.width_mm > 0.0) {
      pdf.line(part.line, true, part.width_mm, {grey, grey, grey});
    } else {
      pdf.fill(part.line, {grey, grey, grey});
    }
  }
  const double bar_end = kSheetWidth_mm / 2 + kBarSquares * kSheetSquare_mm / 2;
  pdf.text(corner + Vec2(bar_end + 3.0, kBarY_mm - 1.75), 5.0,
           formatNumber(kBarSquares * sheet.code.square_m) + " m");
  return pdf.bytes();
}

}  // namespace handmap
