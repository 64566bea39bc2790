#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/pdf/pdf_document.h"
#include "core/report/plan.h"
#include "core/report/report_data.h"

namespace handmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kWidth_mm = 210.0;  // A4
constexpr double kHeight_mm = 297.0;
constexpr double kMargin_mm = 15.0;
constexpr double kInner_mm = kWidth_mm - 2.0 * kMargin_mm;
constexpr double kText_mm = 3.2;
constexpr double kLine_mm = 4.6;
constexpr double kLetter = 0.5;  // its width at most, of the font's size; Japanese: 1
constexpr PdfColour kDrawn = {0.6, 0.6, 0.6};
constexpr PdfColour kFound = {0.0, 0.0, 0.0};
constexpr PdfColour kDoubtful = {0.8, 0.4, 0.0};
constexpr PdfColour kTrue = {0.0, 0.55, 0.2};
constexpr PdfColour kWay = {0.1, 0.3, 0.8};
constexpr double kIsDoubtful = 0.5;

Polygon pointsOf(const Json& outline) {
  Polygon points;
  for (const Json& p : outline) points.emplace_back(p[0].get<double>(), p[1].get<double>());
  return points;
}

bool isWithin(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }  // a character
bool isWide(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]) >= 0xE0;
}

/// In font sizes.
double widthOf(std::string_view text) {
  double width = 0.0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!isWithin(text[i])) width += isWide(text, i) ? 1.0 : kLetter;
  }
  return width;
}

/// How much of a text goes into a line: to a blank, or between two wide characters of which the
/// next does not end a sentence; all of it where there is no such place.
std::size_t lineOf(std::string_view text, double width) {
  std::size_t end = text.size();
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (isWithin(text[i])) continue;
    const std::string_view next = text.substr(i);
    const bool stays = next.starts_with("。") || next.starts_with("、") || next.starts_with("）");
    const bool may_end = text[i] == ' ' || (isWide(text, i) && !stays);
    if (may_end && widthOf(text.substr(0, i)) <= width) end = i;
    if (widthOf(text.substr(0, i)) > width) {
      if (end == text.size() && may_end) end = i;
      if (end < text.size()) return end;
    }
  }
  return widthOf(text) <= width ? text.size() : end;
}

/// From the top to the bottom, page after page.
class Pages {
 public:
  explicit Pages(ReportLanguage language) : pdf_(kWidth_mm, kHeight_mm), language_(language) {
    begin();
  }

  const char* say(const char* english, const char* japanese) const {
    return language_ == ReportLanguage::Japanese ? japanese : english;
  }

  PdfDocument& pdf() { return pdf_; }
  std::string bytes() const { return pdf_.bytes(); }

  /// Room of so many millimetres; its upper end.
  double take(double height_mm) {
    if (top_ - height_mm < kMargin_mm) begin();
    top_ -= height_mm;
    return top_ + height_mm;
  }
  /// So many rows on one page.
  void keepTogether(std::size_t rows) {
    if (top_ - kLine_mm * static_cast<double>(rows) < kMargin_mm) begin();
  }
  void heading(const std::string& text) {
    keepTogether(5);
    take(3.0);
    pdf_.text({kMargin_mm, take(8.0) - 5.0}, 4.5, text);
  }
  void paragraph(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = lineOf(text, kInner_mm / kText_mm);
      row({{0.0, std::string(text.substr(0, end))}});
      text.remove_prefix(std::min(end, text.size()));
      if (text.starts_with(' ')) text.remove_prefix(1);
    }
  }
  void row(const std::vector<std::pair<double, std::string>>& cells) {
    const double y = take(kLine_mm) - kText_mm;
    for (const auto& [x, text] : cells) pdf_.text({kMargin_mm + x, y}, kText_mm, text);
  }

 private:
  void begin() {
    pdf_.beginPage();
    top_ = kHeight_mm - kMargin_mm;
  }

  PdfDocument pdf_;
  ReportLanguage language_;
  double top_ = 0.0;  ///< of what is free
};

bool isDoubtful(const Json& building) { return building.value("doubt", 0.0) > kIsDoubtful; }

std::string nameOf(const Json& building) {
  const auto name = building["name"].get<std::string>();
  return name.empty() ? building["id"].get<std::string>() : name;
}

void addPlan(const Json& data, Pages& pages) {
  constexpr double kPlan_mm = 120.0;
  Polygon way;
  for (const Json& frame : data["frames"])
    way.emplace_back(frame[1].get<double>(), frame[2].get<double>());
  Polygon all = way;
  for (const Json& building : data["buildings"]) {
    for (const char* key : {"refined", "drawn"}) {
      if (!building.contains(key)) continue;
      const Polygon outline = pointsOf(building[key]);
      all.insert(all.end(), outline.begin(), outline.end());
    }
  }
  const Bounds bounds = boundsOf(all);
  const Vec2 size = (bounds.high - bounds.low).cwiseMax(Vec2(1.0, 1.0));
  const double per_metre = std::min(kInner_mm / size.x(), kPlan_mm / size.y());
  const double top = pages.take(size.y() * per_metre + 2.0);
  const auto on_page = [&](Polygon points) {
    for (Vec2& p : points) {
      p = {0.5 * kWidth_mm + per_metre * (p.x() - 0.5 * (bounds.low.x() + bounds.high.x())),
           top - per_metre * (bounds.high.y() - p.y())};
    }
    return points;
  };
  PdfDocument& pdf = pages.pdf();
  for (const Json& building : data["buildings"]) {
    if (building.contains("drawn"))
      pdf.line(on_page(pointsOf(building["drawn"])), true, 0.2, kDrawn);
  }
  for (const Json& outline : data["truth"]) pdf.line(on_page(pointsOf(outline)), true, 0.25, kTrue);
  pdf.line(on_page(way), false, 0.35, kWay);
  for (const Json& building : data["buildings"]) {
    const Polygon outline = on_page(pointsOf(building["refined"]));
    const PdfColour& colour = isDoubtful(building) ? kDoubtful : kFound;
    pdf.line(outline, true, 0.45, colour);
    pdf.text(centroid(outline) - Vec2(2.0, 1.0), 2.4, nameOf(building), colour);
  }
  const double bar_m = roundLength(0.25 * kInner_mm / per_metre);
  const double y = pages.take(7.0) - 4.0;
  pdf.line({{kMargin_mm, y}, {kMargin_mm + bar_m * per_metre, y}}, false, 0.8, kFound);
  pdf.text({kMargin_mm + bar_m * per_metre + 2.0, y - 1.0}, kText_mm, fmt::format("{:g} m", bar_m));
  double x = kMargin_mm + 65.0;
  for (const auto& [word, colour] : {std::pair(pages.say("drawn", "図面"), kDrawn),
                                     {pages.say("corrected", "補正後"), kFound},
                                     {pages.say("doubtful", "疑わしい"), kDoubtful},
                                     {pages.say("way of the robot", "ロボットの経路"), kWay},
                                     {pages.say("true", "真値"), kTrue}}) {
    if (colour == kTrue && data["truth"].empty()) continue;
    pdf.line({{x, y}, {x + 5.0, y}}, false, 0.6, colour);
    pdf.text({x + 6.0, y - 1.0}, kText_mm, word);
    x += 10.0 + 1.1 * kText_mm * widthOf(word);
  }
}

/// One σ of the stated pose over the time of the run.
void addCertainty(const Json& data, Pages& pages) {
  constexpr double kChart_mm = 32.0;
  const Json& frames = data["frames"];
  const double first_s = frames.front()[0].get<double>();
  const double last_s = std::max(first_s + 1e-3, frames.back()[0].get<double>());
  double most = 0.1;
  std::vector<Vec2> sigmas;  // s, m
  for (const Json& frame : frames) {
    const double sigma = std::hypot(frame[4].get<double>(), frame[5].get<double>());
    sigmas.emplace_back(frame[0].get<double>(), sigma);
    most = std::max(most, sigma);
  }
  pages.heading(pages.say("How sure the pose was", "姿勢の確かさ"));
  const double bottom = pages.take(kChart_mm) - kChart_mm;
  Polygon curve;
  for (const Vec2& at : sigmas) {
    curve.emplace_back(kMargin_mm + kInner_mm * (at.x() - first_s) / (last_s - first_s),
                       bottom + kChart_mm * at.y() / most);
  }
  PdfDocument& pdf = pages.pdf();
  pdf.line({{kMargin_mm, bottom},
            {kMargin_mm + kInner_mm, bottom},
            {kMargin_mm + kInner_mm, bottom + kChart_mm},
            {kMargin_mm, bottom + kChart_mm}},
           true, 0.15, kDrawn);
  pdf.line(curve, false, 0.35, kWay);
  pages.paragraph(fmt::format(
      fmt::runtime(pages.say("One sigma of the place over {:.0f} s; the upper edge is {:.2f} m.",
                             "位置の 1σ の {:.0f} 秒間の推移。上端は {:.2f} m です。")),
      last_s - first_s, most));
}

/// As surveyors of base maps state it.
void addSurvey(const Json& survey, Pages& pages) {
  const auto share = [&](const char* key) {
    std::string text;
    for (const Json& walls : survey[key]) {
      text += fmt::format("{}{:.0f}", text.empty() ? "" : " / ",
                          100.0 * walls.get<int>() / std::max(1, survey["walls"].get<int>()));
    }
    return text;
  };
  pages.paragraph(fmt::format(
      fmt::runtime(pages.say(
          "Against the truth: {} of {} buildings are on the map (completeness {:.0f} %). The {} "
          "walls that were seen: rms {:.2f} m as drawn, {:.2f} m corrected; within 0.3 / 0.6 / 1.2 "
          "m {} % as drawn, {} % corrected.",
          "真値との比較: 建物 {1} 棟のうち {0} 棟が地図にあります（完全性 {2:.0f} %）。見えた壁 "
          "{3} "
          "面の二乗平均誤差は、図面で {4:.2f} m、補正後 {5:.2f} m。0.3 / 0.6 / 1.2 m "
          "以内は、図面で {6} %、補正後 {7} %。")),
      survey["present"].get<int>(), survey["buildings"].get<int>(),
      100.0 * survey["present"].get<int>() / std::max(1, survey["buildings"].get<int>()),
      survey["walls"].get<int>(), survey["rms_before_m"].get<double>(),
      survey["rms_after_m"].get<double>(), share("within_before"), share("within_after")));
}

void addWords(const Json& data, Pages& pages) {
  if (data.contains("common")) {
    const Json& common = data["common"];
    pages.paragraph(fmt::format(
        fmt::runtime(pages.say(
            "Together the buildings are {:.2f} m ({:.2f}) east and {:.2f} m ({:.2f}) north of "
            "where they are drawn, turned by {:.2f} ({:.2f}) degrees; each is {:.2f} m off of its "
            "own. In brackets one sigma.",
            "建物は全体として、描かれた位置から東へ {:.2f} m（{:.2f}）、北へ {:.2f} "
            "m（{:.2f}）ずれ、{:.2f}°（{:.2f}）"
            "回っています。それぞれの建物のずれは別に {:.2f} m です。かっこ内は 1σ です。")),
        common["x"].get<double>(), common["sigma_x"].get<double>(), common["y"].get<double>(),
        common["sigma_y"].get<double>(), common["turn_deg"].get<double>(),
        common["sigma_turn_deg"].get<double>(), common["own_m"].get<double>()));
  }
  if (data.contains("survey")) addSurvey(data["survey"], pages);
  const Json& run = data["run"];
  if (!run.contains("warnings") || !run["warnings"].is_array() || run["warnings"].empty()) return;
  pages.heading(pages.say("What went wrong", "うまくいかなかったこと"));
  for (const Json& warning : run["warnings"]) {
    if (!warning.is_object()) continue;
    for (const char* key : {"message", "hint"}) {
      if (warning.contains(key) && warning[key].is_string())
        pages.paragraph(warning[key].get<std::string>());
    }
  }
}

void addTable(const Json& data, Pages& pages) {
  pages.heading(pages.say("Buildings and their walls", "建物とその壁"));
  pages.paragraph(pages.say(
      "sigma: across the wall, metres. The last three: probability that the wall is off by no more "
      "than so much, its building being the right one or not. Walls are counted from the one where "
      "the building's heading points, counter-clockwise.",
      "σ "
      "は壁に直交する向きのもの（m）です。右の三列は、その建物が正しい建物でない場合も含めて、壁の"
      "ずれがその値以内である"
      "確率です。壁は建物の方位が指す側から反時計回りに数えます。"));
  pages.row({{0.0, pages.say("building", "建物")},
             {60.0, pages.say("moved", "移動")},
             {80.0, pages.say("doubt", "疑い")},
             {97.0, pages.say("wall", "壁")},
             {110.0, pages.say("sigma", "σ")},
             {127.0, pages.say("seen", "観測")},
             {142.0, "0.3 m"},
             {156.0, "0.6 m"},
             {170.0, "1.2 m"}});
  for (const Json& building : data["buildings"]) {
    std::vector<std::pair<double, std::string>> cells = {{0.0, nameOf(building)}};
    if (building.contains("moved_m"))
      cells.emplace_back(60.0, fmt::format("{:.2f} m", building["moved_m"].get<double>()));
    if (building.contains("doubt"))
      cells.emplace_back(80.0, fmt::format("{:.0f} %", 100.0 * building["doubt"].get<double>()));
    pages.keepTogether(building["walls"].size());
    int side = 0;
    for (const Json& wall : building["walls"]) {
      cells.emplace_back(97.0, std::to_string(side++));
      cells.emplace_back(110.0, fmt::format("{:.2f}", wall["sigma"].get<double>()));
      cells.emplace_back(
          127.0, wall["seen"].get<bool>() ? pages.say("yes", "あり") : pages.say("no", "なし"));
      for (std::size_t k = 0; k < kTolerances_m.size(); ++k) {
        cells.emplace_back(142.0 + 14.0 * static_cast<double>(k),
                           fmt::format("{:.2f}", wall["within"][k].get<double>()));
      }
      pages.row(std::exchange(cells, {}));
    }
    if (!cells.empty()) pages.row(cells);
  }
}

/// A line for each value, however deep it stands.
void addValues(const std::string& name, const Json& value, Pages& pages) {
  if (!value.is_object()) return pages.paragraph(name + ": " + value.dump());
  for (const auto& [key, inner] : value.items()) {
    addValues(name.empty() ? key : name + "." + key, inner, pages);
  }
}

}  // namespace

std::string reportPdf(const ReportInputs& inputs) {
  const Json data = reportData(inputs);
  Pages pages(inputs.language);
  pages.pdf().text({kMargin_mm, pages.take(12.0) - 7.0}, 7.0, data["title"].get<std::string>());
  pages.paragraph(fmt::format(fmt::runtime(pages.say("Corrected with {}", "{} で補正")),
                              data["program"].get<std::string>()));
  pages.take(3.0);
  addPlan(data, pages);
  addWords(data, pages);
  addCertainty(data, pages);
  addTable(data, pages);
  pages.heading(pages.say("Settings", "設定"));
  for (const char* key : {"program", "recording", "wall_s", "skipped"}) {
    if (data["run"].contains(key)) addValues(key, data["run"][key], pages);
  }
  if (data["run"].contains("settings")) addValues("", data["run"]["settings"], pages);
  return pages.bytes();
}

}  // namespace handmap
