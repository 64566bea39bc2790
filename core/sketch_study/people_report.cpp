#include "core/sketch_study/people_report.h"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace handmap {

namespace {

constexpr int kDraws = 2000;

/// To four digits, never "-0".
std::string figure(double value) { return fmt::format("{:.4g}", value + 0.0); }

std::string drawingTable(const PeopleReport& report) {
  std::string table =
      "| drawing | of the truth | placed | sized | missing | scale | turn deg |\n"
      "|:--------|-------------:|-------:|------:|--------:|------:|---------:|\n";
  for (const DrawnErrors& drawing : report.drawings) {
    int sized = 0;
    for (const DrawnError& error : drawing.of) sized += error.log_size.has_value();
    table += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n",
                         std::filesystem::path(drawing.name).filename().string(), drawing.objects,
                         drawing.of.size(), sized, drawing.objects - drawing.represented,
                         figure(drawing.scale), figure(toDegrees(drawing.turn)));
  }
  return table;
}

std::string figureTable(const PeopleReport& report) {
  std::string table =
      "| figure | value | 95 % from | to |\n"
      "|:-------|------:|----------:|---:|\n";
  const std::vector<PeopleFigure>& all = allPeopleFigures();
  for (std::size_t i = 0; i < all.size(); ++i) {
    table +=
        fmt::format("| {} | {} | {} | {} |\n", all[i].name, figure(report.figures.*all[i].value),
                    figure(report.intervals[i].low), figure(report.intervals[i].high));
  }
  return table;
}

std::string foretoldTable(const std::vector<Foretold>& all) {
  std::string table =
      "| account | within 68 % | within 95 % | log score, normal | heavy tails |\n"
      "|:--------|------------:|------------:|------------------:|------------:|\n";
  for (const Foretold& told : all) {
    table += fmt::format("| {} | {:.2f} | {:.2f} | {:.3f} | {:.3f} |\n", told.account,
                         told.within_68, told.within_95, told.normal_score, told.heavy_score);
  }
  return table;
}

nlohmann::ordered_json toJson(const std::vector<Foretold>& all) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Foretold& told : all) {
    json.push_back({{"account", told.account},
                    {"within_68", told.within_68},
                    {"within_95", told.within_95},
                    {"normal_score", told.normal_score},
                    {"heavy_score", told.heavy_score}});
  }
  return json;
}

}  // namespace

PeopleReport peopleReport(std::vector<DrawnErrors> drawings, std::uint64_t seed) {
  PeopleReport report;
  report.figures = peopleFigures(drawings);
  report.intervals = peopleIntervals(drawings, kDraws, seed);
  report.places = foretellPlaces(drawings);
  report.sizes = foretellSizes(drawings);
  report.drawings = std::move(drawings);
  return report;
}

std::string formatText(const PeopleReport& report) {
  std::string text = drawingTable(report) + "\n" + figureTable(report);
  if (report.drawings.size() < 2) return text;
  text += "\nPlaces of each drawing as the others tell them\n\n" + foretoldTable(report.places);
  return text + "\nSizes of each drawing as the others tell them\n\n" + foretoldTable(report.sizes);
}

std::string formatJson(const PeopleReport& report) {
  nlohmann::ordered_json drawings = nlohmann::ordered_json::array();
  for (const DrawnErrors& drawing : report.drawings) {
    drawings.push_back({{"drawing", drawing.name},
                        {"objects", drawing.objects},
                        {"placed", drawing.of.size()},
                        {"missing", drawing.objects - drawing.represented},
                        {"scale", drawing.scale},
                        {"turn_deg", toDegrees(drawing.turn)},
                        {"extent_m", drawing.extent}});
  }
  nlohmann::ordered_json figures;
  const std::vector<PeopleFigure>& all = allPeopleFigures();
  for (std::size_t i = 0; i < all.size(); ++i) {
    figures[all[i].name] = {{"value", report.figures.*all[i].value},
                            {"low", report.intervals[i].low},
                            {"high", report.intervals[i].high}};
  }
  nlohmann::ordered_json json = {{"drawings", drawings}, {"figures", figures}};
  if (report.drawings.size() > 1) {
    json["places_foretold"] = toJson(report.places);
    json["sizes_foretold"] = toJson(report.sizes);
  }
  return json.dump(2) + "\n";
}

}  // namespace handmap
