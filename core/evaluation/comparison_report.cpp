#include "core/evaluation/comparison_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace handmap {

namespace {

using Json = nlohmann::ordered_json;

bool wanted(const ComparisonReport& report, const std::string& id) {
  const auto& only = report.only;
  return only.empty() || std::find(only.begin(), only.end(), id) != only.end();
}

std::vector<BuildingError> rowsOf(const ComparisonReport& report, const MapComparison& comparison) {
  std::vector<BuildingError> rows;
  for (const BuildingError& error : comparison.buildings) {
    if (wanted(report, error.id)) rows.push_back(error);
  }
  return rows;
}

std::vector<std::string> wantedOf(const ComparisonReport& report,
                                  const std::vector<std::string>& ids) {
  std::vector<std::string> result;
  for (const std::string& id : ids) {
    if (wanted(report, id)) result.push_back(id);
  }
  return result;
}

/// Signed, in centimetres' steps, never "-0.00".
std::string signedMetres(double value) {
  return fmt::format("{:+.2f}", std::round(value * 100.0) / 100.0 + 0.0);
}

std::string formatTable(const ComparisonReport& report, const MapComparison& comparison) {
  constexpr auto kRow = "| {:<{}} | {:>7} | {:>7} | {:>7} | {:>5} | {:>8} |\n";
  const std::vector<BuildingError> rows = rowsOf(report, comparison);
  const MeanErrors mean = comparison.mean(report.only);
  const std::string mean_name = fmt::format("mean of {}", mean.buildings);
  std::size_t name_width = mean_name.size();
  for (const BuildingError& row : rows) name_width = std::max(name_width, row.id.size());

  std::string table =
      fmt::format(kRow, "building", name_width, "x m", "front m", "width m", "IoU", "overlaps");
  table +=
      fmt::format("|:{:-<{}}-|--------:|--------:|--------:|------:|---------:|\n", "", name_width);
  for (const BuildingError& row : rows) {
    table += fmt::format(kRow, row.id, name_width, signedMetres(row.x), signedMetres(row.front),
                         signedMetres(row.width), fmt::format("{:.2f}", row.iou),
                         row.overlaps ? "yes" : "no");
  }
  if (rows.empty()) return table;
  const auto hits = std::count_if(rows.begin(), rows.end(),
                                  [](const BuildingError& row) { return row.overlaps; });
  return table + fmt::format(kRow, mean_name, name_width, fmt::format("{:.2f}", mean.x),
                             fmt::format("{:.2f}", mean.front), fmt::format("{:.2f}", mean.width),
                             fmt::format("{:.2f}", mean.iou),
                             fmt::format("{} of {}", hits, rows.size()));
}

std::string formatTrajectory(const TrajectoryError& error) {
  return fmt::format(
      "\nTrajectory: {} poses, {:.1f} m\n\n"
      "| rms m | max m | end m | heading rms deg | aligned rms m |\n"
      "|------:|------:|------:|----------------:|--------------:|\n"
      "| {:>5.2f} | {:>5.2f} | {:>5.2f} | {:>15.2f} | {:>13.2f} |\n",
      error.poses, error.length_m, error.rms_m, error.max_m, error.end_m,
      toDegrees(error.rms_heading), error.aligned_rms_m);
}

Json toJson(const ComparisonReport& report, const MapComparison& comparison) {
  Json buildings = Json::array();
  for (const BuildingError& row : rowsOf(report, comparison)) {
    buildings.push_back({{"id", row.id},
                         {"x", row.x},
                         {"front", row.front},
                         {"width", row.width},
                         {"iou", row.iou},
                         {"overlaps", row.overlaps}});
  }
  const MeanErrors mean = comparison.mean(report.only);
  const Pose2& shift = comparison.alignment;
  return {{"alignment", {shift.x, shift.y, shift.heading}},
          {"buildings", buildings},
          {"mean",
           {{"buildings", mean.buildings},
            {"x", mean.x},
            {"front", mean.front},
            {"width", mean.width},
            {"iou", mean.iou}}}};
}

Json toJson(const TrajectoryError& error) {
  return {{"poses", error.poses},
          {"length_m", error.length_m},
          {"rms_m", error.rms_m},
          {"max_m", error.max_m},
          {"end_m", error.end_m},
          {"rms_heading_rad", error.rms_heading},
          {"aligned_rms_m", error.aligned_rms_m}};
}

}  // namespace

std::string formatText(const ComparisonReport& report) {
  const Pose2& shift = report.aligned.alignment;
  std::string text = "As it is\n\n" + formatTable(report, report.as_it_is);
  text += fmt::format("\nAligned: moved by {} m, {} m, turned by {} deg\n\n", signedMetres(shift.x),
                      signedMetres(shift.y), signedMetres(toDegrees(shift.heading)));
  text += formatTable(report, report.aligned);
  const auto missing = wantedOf(report, report.as_it_is.missing);
  const auto extra = wantedOf(report, report.as_it_is.extra);
  if (!missing.empty()) text += fmt::format("\nOnly in the truth: {}\n", fmt::join(missing, ", "));
  if (!extra.empty()) text += fmt::format("\nNot in the truth: {}\n", fmt::join(extra, ", "));
  if (report.trajectory) text += formatTrajectory(*report.trajectory);
  return text;
}

std::string formatJson(const ComparisonReport& report) {
  Json json = {{"as_it_is", toJson(report, report.as_it_is)},
               {"aligned", toJson(report, report.aligned)},
               {"missing", wantedOf(report, report.as_it_is.missing)},
               {"extra", wantedOf(report, report.as_it_is.extra)}};
  if (report.trajectory) json["trajectory"] = toJson(*report.trajectory);
  return json.dump(2) + "\n";
}

}  // namespace handmap
