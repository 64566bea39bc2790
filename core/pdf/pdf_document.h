// Pages of lines, outlines and text as PDF (ISO 32000-1). Millimetres, x right, y up, from the
// lower left corner of the page.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/polygon.h"

namespace handmap {

/// Red, green, blue; 0 to 1.
using PdfColour = std::array<double, 3>;

class PdfDocument {
 public:
  PdfDocument(double width_mm, double height_mm) : width_mm_(width_mm), height_mm_(height_mm) {}

  /// All that is drawn is on the page that was begun last.
  void beginPage() { pages_.emplace_back(); }
  void fill(const Polygon& outline, const PdfColour& colour);
  void line(const Polygon& points, bool closed, double width_mm, const PdfColour& colour);
  /// UTF-8, what is no valid character left out; `size_mm`: of the font.
  void text(const Vec2& at, double size_mm, std::string_view text, const PdfColour& colour = {});

  std::string bytes() const;

 private:
  void path(const Polygon& points);

  double width_mm_;
  double height_mm_;
  std::vector<std::string> pages_;  ///< what draws them
};

}  // namespace handmap
