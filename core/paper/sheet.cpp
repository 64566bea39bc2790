#include "core/paper/sheet.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

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

constexpr double kA4Width_mm = 297.0, kA4Height_mm = 210.0;
constexpr double kLargestName_mm = 5.0, kSmallestName_mm = 2.0;
constexpr double kLetterWidth = 0.55;  // of the size of the font

Vec2 gridCorner() {
  return {0.5 * (kA4Width_mm - kSheetWidth_mm), 0.5 * (kA4Height_mm - kSheetHeight_mm)};
}

PdfColour greyOf(double darkness) {
  const double grey = 1.0 - darkness;
  return {grey, grey, grey};
}

Polygon pointsOf(const Map& map) {
  Polygon points = map.route;
  for (const Building& building : map.buildings) {
    const Polygon outline = building.footprint();
    points.insert(points.end(), outline.begin(), outline.end());
  }
  if (map.start) points.push_back(map.start->position());
  return points;
}

/// Steps that are whole; nullopt: they are not, or more than the code can tell.
std::optional<std::array<int, 2>> cornerSteps(const Sheet& sheet) {
  const Vec2 steps = kCornerSteps * sheet.corner / sheet.code.square_m;
  const Vec2 whole = steps.array().round();
  if ((steps - whole).cwiseAbs().maxCoeff() > 1e-3 ||
      whole.cwiseAbs().maxCoeff() > kMostCornerSteps)
    return std::nullopt;
  return std::array{static_cast<int>(whole.x()), static_cast<int>(whole.y())};
}

bool holds(const Sheet& sheet, const Polygon& points) {
  return std::ranges::all_of(points, [&](const Vec2& point) {
    const Vec2 at = sheet.toPaper(point);
    return at.x() >= 0.0 && at.y() >= 0.0 && at.x() <= kSheetWidth_mm && at.y() <= kSheetHeight_mm;
  });
}

void draw(PdfDocument& pdf, const std::vector<SheetPart>& parts) {
  for (SheetPart part : parts) {
    for (Vec2& point : part.line) point += gridCorner();
    if (part.width_mm > 0.0) {
      pdf.line(part.line, true, part.width_mm, greyOf(part.darkness));
    } else {
      pdf.fill(part.line, greyOf(part.darkness));
    }
  }
}

double widthOf(const std::string& text, double size_mm) {
  const auto letters = std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; });
  const bool wide =
      std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) >= 0xE0; });
  return (wide ? 1.0 : kLetterWidth) * size_mm * static_cast<double>(letters);
}

void write(PdfDocument& pdf, const std::vector<SheetName>& names) {
  for (const SheetName& name : names) {
    const Vec2 left(-0.5 * widthOf(name.text, name.size_mm), -0.35 * name.size_mm);
    pdf.text(gridCorner() + name.at + left, name.size_mm, name.text, greyOf(kDarkestPrint));
  }
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

std::optional<Sheet> sheetOf(const SheetCode& code) {
  if (!code.of_map) return emptySheet(code);
  if (!code.corner) return std::nullopt;
  Sheet sheet;
  sheet.code = code;
  sheet.corner = code.square_m / kCornerSteps * Vec2((*code.corner)[0], (*code.corner)[1]);
  return sheet;
}

std::optional<Sheet> sheetUnder(const Map& map) {
  for (const Underlay& underlay : map.underlays) {
    const auto told = underlay.unknown.find(kPaperKey);
    if (told == underlay.unknown.end() || underlay.heading != 0.0) continue;
    const nlohmann::json json = nlohmann::json::parse(told->second, nullptr, false);
    if (!json.is_object() || !json.contains("square_m") || !json["square_m"].is_number()) continue;
    Sheet sheet;
    sheet.code = {json["square_m"].get<double>(), true};
    if (std::ranges::find(kSquares_m, sheet.code.square_m) == kSquares_m.end()) continue;
    sheet.corner = {underlay.x, underlay.y - sheet.metres_per_mm() * kSheetHeight_mm};
    sheet.code.corner = cornerSteps(sheet);
    sheet.start = map.start.value_or(Pose2{0.0, 0.0, kPi / 2.0});
    if (sheet.code.corner) return sheet;
  }
  return std::nullopt;
}

Sheet sheetFor(const Map& map) {
  const Polygon points = pointsOf(map);
  if (points.empty()) return emptySheet(SheetCode{});
  if (const auto under = sheetUnder(map); under && holds(*under, points)) return *under;
  const Bounds bounds = boundsOf(points);
  const Vec2 size = bounds.high - bounds.low;
  Sheet sheet;
  sheet.code = {squareFor(size.x(), size.y()), true};
  // In whole steps, which its code can tell; by less than the outlines are thick it is off.
  const double step_m = sheet.code.square_m / kCornerSteps;
  const Vec2 corner = (bounds.low + bounds.high) / 2.0 -
                      sheet.metres_per_mm() * Vec2(kSheetWidth_mm, kSheetHeight_mm) / 2.0;
  sheet.corner = step_m * Vec2((corner / step_m).array().round());
  sheet.code.corner = cornerSteps(sheet);
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
    const std::vector<SheetPart> outlines = outlineParts(sheet, *map);
    parts.insert(parts.end(), outlines.begin(), outlines.end());
  }
  const auto places = markPlaces();
  for (std::size_t i = 0; i < places.size(); ++i) addMark(parts, places[i], i == 0);
  const auto cells = codeCells(sheet.code);
  for (int i = 0; i < kCodeCells; ++i) {
    if (cells[static_cast<std::size_t>(i)])
      parts.push_back({boxAround(codePlace(i), kCodeCell_mm, kCodeCell_mm), 1.0, 0.0});
  }
  const auto place = placeCells(sheet.code);
  for (int i = 0; i < kPlaceCells; ++i) {
    if (place[static_cast<std::size_t>(i)])
      parts.push_back({boxAround(placeCellPlace(i), kCodeCell_mm, kCodeCell_mm), 1.0, 0.0});
  }
  addScale(parts);
  return parts;
}

std::vector<SheetPart> outlineParts(const Sheet& sheet, const Map& map) {
  std::vector<SheetPart> parts;
  for (const Building& building : map.buildings) {
    Polygon outline = building.footprint();
    for (Vec2& corner : outline) corner = sheet.toPaper(corner);
    parts.push_back({outline, kDarkestPrint, 0.5});
  }
  return parts;
}

std::vector<SheetName> sheetNames(const Sheet& sheet, const Map& map) {
  std::vector<SheetName> names;
  for (const Building& building : map.buildings) {
    if (building.name.empty()) continue;
    const Polygon outline = building.footprint();
    const Bounds bounds = boundsOf(outline);
    const Vec2 size = (bounds.high - bounds.low) / sheet.metres_per_mm();
    const double fits = 0.9 * size.x() / widthOf(building.name, 1.0);
    names.push_back({sheet.toPaper(centroid(outline)),
                     std::clamp(std::min(fits, 0.6 * size.y()), kSmallestName_mm, kLargestName_mm),
                     building.name});
  }
  return names;
}

std::string sheetPdf(const Sheet& sheet, const Map* map) {
  PdfDocument pdf(kA4Width_mm, kA4Height_mm);
  pdf.beginPage();
  draw(pdf, sheetParts(sheet, map));
  if (map) write(pdf, sheetNames(sheet, *map));
  const double bar_end = kSheetWidth_mm / 2 + kBarSquares * kSheetSquare_mm / 2;
  pdf.text(gridCorner() + Vec2(bar_end + 3.0, kBarY_mm - 1.75), 5.0,
           formatNumber(kBarSquares * sheet.code.square_m) + " m");
  return pdf.bytes();
}

std::string overprintPdf(const Map& map) {
  const auto sheet = sheetUnder(map);
  if (!sheet) {
    throwBadInput(phrase("the sheet"), "", phrase("no printed sheet under the map"),
                  phrase("a map that was drawn on one"));
  }
  PdfDocument pdf(kA4Width_mm, kA4Height_mm);
  pdf.beginPage();
  draw(pdf, outlineParts(*sheet, map));
  write(pdf, sheetNames(*sheet, map));
  return pdf.bytes();
}

}  // namespace handmap
