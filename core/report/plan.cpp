#include "core/report/plan.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/map/certainty.h"
#include "core/pdf/pdf_document.h"

namespace handmap {

namespace {

constexpr double kLong_mm = 297.0;  // A4
constexpr double kShort_mm = 210.0;
constexpr double kBorder_mm = 12.0;
constexpr double kLegend_mm = 10.0;
constexpr double kTitle_mm = 12.0;
constexpr double kWords_mm = 3.2;
constexpr double kNarrow = 0.55;  // its width, of the font's size
constexpr PdfColour kInk = {0.25, 0.25, 0.25};
constexpr PdfColour kCorrected = {0.0, 0.35, 0.85};
constexpr PdfColour kUnsure = {0.8, 0.4, 0.0};
constexpr PdfColour kRoute = {0.9, 0.5, 0.0};
constexpr double kUnsureFrom = 0.5;

/// As many of the font's sizes as a text is wide; Japanese is twice as wide.
double sizesOf(const std::string& text) {
  double width = 0.0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) != 0x80U) width += byte >= 0xE0 ? 1.0 : kNarrow;
  }
  return width;
}

/// Millimetres, x right, y up, from the lower left corner.
class Sheet {
 public:
  explicit Sheet(const Vec2& size_mm) : size_mm_(size_mm) {}
  virtual ~Sheet() = default;
  virtual void line(const Polygon& points, bool closed, double width_mm,
                    const PdfColour& colour) = 0;
  virtual void text(const Vec2& at, double size_mm, const std::string& text,
                    const PdfColour& colour) = 0;
  virtual std::string bytes() = 0;
  virtual bool hasLettersOf(const std::string&) const { return true; }
  const Vec2& size() const { return size_mm_; }

 protected:
  /// With y down.
  Vec2 fromTop(const Vec2& point) const { return {point.x(), size_mm_.y() - point.y()}; }

 private:
  Vec2 size_mm_;
};

class PdfSheet : public Sheet {
 public:
  explicit PdfSheet(const Vec2& size_mm) : Sheet(size_mm), pdf_(size_mm.x(), size_mm.y()) {
    pdf_.beginPage();
  }
  void line(const Polygon& points, bool closed, double width_mm, const PdfColour& colour) override {
    pdf_.line(points, closed, width_mm, colour);
  }
  void text(const Vec2& at, double size_mm, const std::string& text,
            const PdfColour& colour) override {
    pdf_.text(at, size_mm, text, colour);
  }
  std::string bytes() override { return pdf_.bytes(); }

 private:
  PdfDocument pdf_;
};

class SvgSheet : public Sheet {
 public:
  explicit SvgSheet(const Vec2& size_mm)
      : Sheet(size_mm),
        svg_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" "
                         "height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n"
                         "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
                         size_mm.x(), size_mm.y())) {}
  void line(const Polygon& points, bool closed, double width_mm, const PdfColour& colour) override {
    std::string path;
    for (const Vec2& point : points) {
      const Vec2 at = fromTop(point);
      path += fmt::format("{:.3f},{:.3f} ", at.x(), at.y());
    }
    svg_ += fmt::format(
        "<{} points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
        "stroke-linejoin=\"round\"/>\n",
        closed ? "polygon" : "polyline", path, hex(colour), width_mm);
  }
  void text(const Vec2& at, double size_mm, const std::string& text,
            const PdfColour& colour) override {
    const Vec2 place = fromTop(at);
    svg_ += fmt::format(
        "<text x=\"{:.3f}\" y=\"{:.3f}\" font-family=\"sans-serif\" font-size=\"{}\" "
        "fill=\"{}\">{}</text>\n",
        place.x(), place.y(), size_mm, hex(colour), escaped(text));
  }
  std::string bytes() override { return svg_ + "</svg>\n"; }

 private:
  static std::string hex(const PdfColour& colour) {
    const auto part = [&](std::size_t i) { return static_cast<int>(std::lround(255 * colour[i])); };
    return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
  }
  /// XML knows no control characters.
  static std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
      if (c == '&' || c == '<') {
        safe += c == '&' ? "&amp;" : "&lt;";
      } else if (static_cast<unsigned char>(c) >= 0x20) {
        safe += c;
      }
    }
    return safe;
  }

  std::string svg_;
};

class PngSheet : public Sheet {
 public:
  explicit PngSheet(const Vec2& size_mm)
      : Sheet(size_mm),
        picture_(static_cast<int>(size_mm.y() * kPixels), static_cast<int>(size_mm.x() * kPixels),
                 CV_8UC3, cv::Scalar::all(255)) {}
  void line(const Polygon& points, bool closed, double width_mm, const PdfColour& colour) override {
    std::vector<cv::Point> pixels;
    for (const Vec2& point : points) pixels.push_back(pixel(point));
    cv::polylines(picture_, pixels, closed, bgr(colour),
                  std::max(1, static_cast<int>(std::lround(kPixels * width_mm))), cv::LINE_AA,
                  kShift);
  }
  void text(const Vec2& at, double size_mm, const std::string& text,
            const PdfColour& colour) override {
    constexpr double kHeight = 30.0;  // pixels, of this font at 1
    const Vec2 place = kPixels * fromTop(at);
    cv::putText(
        picture_, text,
        {static_cast<int>(std::lround(place.x())), static_cast<int>(std::lround(place.y()))},
        cv::FONT_HERSHEY_SIMPLEX, kPixels * size_mm / kHeight, bgr(colour), 2, cv::LINE_AA);
  }
  std::string bytes() override {
    std::vector<unsigned char> file;
    cv::imencode(".png", picture_, file);
    return {file.begin(), file.end()};
  }
  bool hasLettersOf(const std::string& text) const override {
    return std::ranges::all_of(text, [](char c) { return c >= 0x20 && c < 0x7f; });
  }

 private:
  static constexpr double kPixels = 8.0;  // a millimetre: 203 dots an inch
  static constexpr int kShift = 4;        // bits of a pixel's fraction

  cv::Point pixel(const Vec2& point) const {
    const Vec2 at = (1 << kShift) * kPixels * fromTop(point);
    return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
  }
  static cv::Scalar bgr(const PdfColour& colour) {
    return {255 * colour[2], 255 * colour[1], 255 * colour[0]};
  }

  cv::Mat picture_;
};

Polygon everythingOn(const Map& map) {
  Polygon all = map.route;
  for (const Building& building : map.buildings) {
    const Polygon outline = building.footprint();
    all.insert(all.end(), outline.begin(), outline.end());
  }
  for (const Landmark& landmark : map.landmarks) all.push_back(landmark.position);
  if (map.start) all.push_back(map.start->position());
  return all;
}

std::unique_ptr<Sheet> sheetOf(const std::string& ending, const Vec2& size_mm) {
  if (ending == "svg") return std::make_unique<SvgSheet>(size_mm);
  if (ending == "png") return std::make_unique<PngSheet>(size_mm);
  return std::make_unique<PdfSheet>(size_mm);
}

/// Draws a map into a sheet, as large as it can be.
class Plan {
 public:
  Plan(const Map& map, const Bounds& bounds, Sheet& sheet) : map_(map), sheet_(sheet) {
    const Vec2 room =
        sheet.size() - Vec2(2.0 * kBorder_mm, 2.0 * kBorder_mm + kLegend_mm + kTitle_mm);
    const Vec2 size = (bounds.high - bounds.low).cwiseMax(Vec2(1.0, 1.0));
    per_metre_ = std::min(room.x() / size.x(), room.y() / size.y());
    middle_m_ = 0.5 * (bounds.low + bounds.high);
    middle_mm_ = Vec2(kBorder_mm, kBorder_mm + kLegend_mm) + 0.5 * room;
  }

  void draw() {
    if (map_.route.size() > 1) sheet_.line(onSheet(map_.route), false, 0.3, kRoute);
    for (const Building& building : map_.buildings) addBuilding(building);
    for (const Landmark& landmark : map_.landmarks) {
      const Vec2 at = onSheet({landmark.position}).front();
      cross(at);
      sheet_.text(at + Vec2(1.5, 0.5), 2.4, nameOf(landmark.name, landmark.id), kInk);
    }
    if (map_.start) addStart(*map_.start);
    addLegend();
  }

 private:
  Polygon onSheet(Polygon points) const {
    for (Vec2& p : points) p = middle_mm_ + per_metre_ * (p - middle_m_);
    return points;
  }
  std::string nameOf(const std::string& name, const std::string& id) const {
    return name.empty() || !sheet_.hasLettersOf(name) ? id : name;
  }
  void addBuilding(const Building& building) {
    const Polygon outline = onSheet(building.footprint());
    const bool is_found = isRecognised(building);
    const bool is_doubtful = doubtOf(building) > kUnsureFrom;
    has_found_ = has_found_ || (is_found && !is_doubtful);
    has_doubtful_ = has_doubtful_ || is_doubtful;
    const PdfColour& colour = is_doubtful ? kUnsure : is_found ? kCorrected : kInk;
    sheet_.line(outline, true, is_found ? 0.5 : 0.3, colour);
    const std::string name = nameOf(building.name, building.id);
    constexpr double kName_mm = 2.6;
    sheet_.text(centroid(outline) - kName_mm * Vec2(0.5 * sizesOf(name), 0.35), kName_mm, name,
                colour);
  }
  void cross(const Vec2& at) {
    sheet_.line({at - Vec2(1.0, 0.0), at + Vec2(1.0, 0.0)}, false, 0.3, kInk);
    sheet_.line({at - Vec2(0.0, 1.0), at + Vec2(0.0, 1.0)}, false, 0.3, kInk);
  }
  void addStart(const Pose2& start) {
    const Vec2 at = onSheet({start.position()}).front();
    const Pose2 arrow{at.x(), at.y(), start.heading};
    sheet_.line(
        {arrow.toOuter({-1.5, 1.2}), arrow.toOuter({2.5, 0.0}), arrow.toOuter({-1.5, -1.2})}, true,
        0.5, kRoute);
  }
  void addLegend() {
    if (sheet_.hasLettersOf(map_.name)) {
      sheet_.text({kBorder_mm, sheet_.size().y() - kBorder_mm - 5.0}, 5.0, map_.name, kInk);
    }
    const double bar_m = roundLength(0.25 * (sheet_.size().x() - 2.0 * kBorder_mm) / per_metre_);
    const double y = kBorder_mm;
    double x = kBorder_mm + bar_m * per_metre_;
    sheet_.line({{kBorder_mm, y}, {x, y}}, false, 0.8, kInk);
    sheet_.text({x + 2.0, y - 1.0}, kWords_mm, fmt::format("{:g} m", bar_m), kInk);
    x += 22.0;
    const auto add = [&](bool is_there, const std::string& word, const PdfColour& colour) {
      if (!is_there) return;
      sheet_.line({{x, y}, {x + 6.0, y}}, false, 0.6, colour);
      sheet_.text({x + 7.5, y - 1.0}, kWords_mm, word, colour);
      x += 12.0 + kWords_mm * sizesOf(word);
    };
    add(!map_.buildings.empty(), "drawn", kInk);
    add(has_found_, "corrected", kCorrected);
    add(has_doubtful_, "doubtful", kUnsure);
    add(map_.start || map_.route.size() > 1, "start and way", kRoute);
  }

  const Map& map_;
  Sheet& sheet_;
  double per_metre_ = 1.0;
  Vec2 middle_m_;
  Vec2 middle_mm_;
  bool has_found_ = false;
  bool has_doubtful_ = false;
};

}  // namespace

const std::vector<std::string>& planEndings() {
  static const std::vector<std::string> kEndings = {"pdf", "svg", "png"};
  return kEndings;
}

std::string formatPlan(const Map& map, const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending.empty() || std::ranges::find(planEndings(), ending.substr(1)) == planEndings().end()) {
    throwBadInput(path.string(), "", phrase("another ending"),
                  fmt::format("{}", fmt::join(planEndings(), ", ")));
  }
  const Polygon all = everythingOn(map);
  if (all.empty()) {
    throwBadInput(path.string(), "buildings", phrase("none"), phrase("at least one"));
  }
  const Bounds bounds = boundsOf(all);
  const Vec2 size = bounds.high - bounds.low;
  const bool is_wide = size.x() >= size.y();
  const auto sheet =
      sheetOf(ending.substr(1), is_wide ? Vec2(kLong_mm, kShort_mm) : Vec2(kShort_mm, kLong_mm));
  Plan(map, bounds, *sheet).draw();
  return sheet->bytes();
}

double roundLength(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return power * (most >= 5.0 * power ? 5.0 : most >= 2.0 * power ? 2.0 : 1.0);
}

}  // namespace handmap
