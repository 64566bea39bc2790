#include "core/pdf/pdf_document.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

namespace handmap {

namespace {

constexpr double kPoint_mm = 25.4 / 72.0;

/// What is no character is passed over.
std::vector<char32_t> charactersOf(std::string_view utf8) {
  std::vector<char32_t> characters;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto first = static_cast<unsigned char>(utf8[i]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    char32_t character = length == 1 ? first : first & (0x7FU >> length);
    bool whole = (first < 0x80 || first >= 0xC2) && first < 0xF5 && i + length <= utf8.size();
    for (std::size_t k = 1; whole && k < length; ++k) {
      const auto next = static_cast<unsigned char>(utf8[i + k]);
      whole = (next & 0xC0U) == 0x80U;
      character = character << 6U | (next & 0x3FU);
    }
    if (whole && character >= 0x20) characters.push_back(character);
    i += whole ? length : 1;
  }
  return characters;
}

/// As WinAnsiEncoding has them; it is Latin-1 there.
bool isLatin(char32_t c) { return c < 0x7F || (c >= 0xA0 && c <= 0xFF); }

std::string literalOf(const std::vector<char32_t>& characters) {
  std::string literal = "(";
  for (const char32_t c : characters) {
    if (c == '(' || c == ')' || c == '\\') literal += '\\';
    literal += static_cast<char>(static_cast<unsigned char>(c));
  }
  return literal + ")";
}

std::string utf16Of(const std::vector<char32_t>& characters) {
  std::string hex = "<";
  for (const char32_t c : characters) {
    const auto code = static_cast<std::uint32_t>(c);
    if (code < 0x10000) {
      hex += fmt::format("{:04X}", code);
    } else {
      hex += fmt::format("{:04X}{:04X}", 0xD800 + ((code - 0x10000) >> 10U),
                         0xDC00 + ((code - 0x10000) & 0x3FFU));
    }
  }
  return hex + ">";
}

/// The font that a viewer brings for Japanese, where it has one; and what it is made of.
const std::vector<std::string>& fontObjects() {
  static const std::vector<std::string> kObjects = {
      "<</Type/Font/Subtype/Type1/BaseFont/Helvetica/Encoding/WinAnsiEncoding>>",
      "<</Type/Font/Subtype/Type0/BaseFont/HeiseiKakuGo-W5/Encoding/UniJIS-UTF16-H"
      "/DescendantFonts[5 0 R]>>",
      "<</Type/Font/Subtype/CIDFontType0/BaseFont/HeiseiKakuGo-W5/DW 1000/W[1 230 "
      "500]/CIDSystemInfo<<"
      "/Registry(Adobe)/Ordering(Japan1)/Supplement 4>>/FontDescriptor 6 0 R>>",
      "<</Type/FontDescriptor/FontName/HeiseiKakuGo-W5/Flags 4/FontBBox[-92 -250 1010 922]"
      "/ItalicAngle 0/Ascent 752/Descent -221/CapHeight 737/StemV 114>>"};
  return kObjects;
}
constexpr std::size_t kFirstFont = 3;  // number of their first object

}  // namespace

void PdfDocument::path(const Polygon& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    pages_.back() +=
        fmt::format("{:.3f} {:.3f} {}\n", points[i].x(), points[i].y(), i == 0 ? "m" : "l");
  }
}

void PdfDocument::fill(const Polygon& outline, const PdfColour& colour) {
  pages_.back() += fmt::format("{:.3f} {:.3f} {:.3f} rg\n", colour[0], colour[1], colour[2]);
  path(outline);
  pages_.back() += "f\n";
}

void PdfDocument::line(const Polygon& points, bool closed, double width_mm,
                       const PdfColour& colour) {
  pages_.back() +=
      fmt::format("{:.3f} {:.3f} {:.3f} RG {:.3f} w\n", colour[0], colour[1], colour[2], width_mm);
  path(points);
  pages_.back() += closed ? "s\n" : "S\n";
}

void PdfDocument::text(const Vec2& at, double size_mm, std::string_view text,
                       const PdfColour& colour) {
  const std::vector<char32_t> characters = charactersOf(text);
  const bool latin = std::ranges::all_of(characters, isLatin);
  pages_.back() +=
      fmt::format("{:.3f} {:.3f} {:.3f} rg BT /{} {:.3f} Tf {:.3f} {:.3f} Td {} Tj ET\n", colour[0],
                  colour[1], colour[2], latin ? "F" : "J", size_mm, at.x(), at.y(),
                  latin ? literalOf(characters) : utf16Of(characters));
}

std::string PdfDocument::bytes() const {
  const std::size_t first_page = kFirstFont + fontObjects().size();
  std::string kids;
  for (std::size_t i = 0; i < pages_.size(); ++i)
    kids += fmt::format("{} 0 R ", first_page + 2 * i);
  std::vector<std::string> objects = {
      "<</Type/Catalog/Pages 2 0 R>>",
      fmt::format("<</Type/Pages/Kids[{}]/Count {}>>", kids, pages_.size())};
  objects.insert(objects.end(), fontObjects().begin(), fontObjects().end());
  for (const std::string& page : pages_) {
    const std::string drawing = fmt::format("{0:.5f} 0 0 {0:.5f} 0 0 cm\n", 1.0 / kPoint_mm) + page;
    objects.push_back(
        fmt::format("<</Type/Page/Parent 2 0 R/MediaBox[0 0 {:.2f} {:.2f}]"
                    "/Contents {} 0 R/Resources<</Font<</F 3 0 R/J 4 0 R>>>>>>",
                    width_mm_ / kPoint_mm, height_mm_ / kPoint_mm, objects.size() + 2));
    objects.push_back(fmt::format("<</Length {}>>\nstream\n{}endstream", drawing.size(), drawing));
  }
  std::string pdf = "%PDF-1.4\n";
  std::string table = fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects.size() + 1);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    table += fmt::format("{:010} 00000 n \n", pdf.size());
    pdf += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
  }
  const std::size_t table_at = pdf.size();
  return pdf + table +
         fmt::format("trailer\n<</Size {}/Root 1 0 R>>\nstartxref\n{}\n%%EOF\n", objects.size() + 1,
                     table_at);
}

}  // namespace handmap
