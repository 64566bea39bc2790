#include "app/cli/run_summary.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/evaluation/common_shift.h"

namespace handmap {

std::string runSummary(const Map& drawing, const RunSession& session) {
  constexpr auto kRow = "| {:<{}} | {:>8.2f} | {:>8.2f} | {:>7.2f} | {:>7.2f} |";
  const Map map = session.refinedMap();
  std::size_t id_width = 8;
  for (const Building& building : map.buildings) id_width = std::max(id_width, building.id.size());

  const Pose2 pose = session.trajectory().back().pose;
  std::string text = fmt::format(
      "{} observations used, {} skipped\n"
      "robot at {:.2f} m, {:.2f} m, heading {:.1f} deg\n\n"
      "| {:<{}} |      x m |      y m | width m | depth m | sigma x | sigma y | sigma w | seen |\n"
      "|:{:-<{}}-|---------:|---------:|--------:|--------:|--------:|--------:|--------:|-----:|"
      "\n",
      session.frames().size(), session.skipped().size(), pose.x, pose.y, toDegrees(pose.heading),
      "building", id_width, "", id_width);
  for (const Building& building : map.buildings) {
    const Rectangle box = building.box();
    text += fmt::format(kRow, building.id, id_width, box.centre.x(), box.centre.y(), box.width,
                        box.depth);
    if (building.estimate) {
      const Estimate& estimate = *building.estimate;
      text += fmt::format(" {:>7.2f} | {:>7.2f} | {:>7.2f} | {:>4} |\n", estimate.sigma_x,
                          estimate.sigma_y, estimate.sigma_width, estimate.observations);
    } else {
      text += fmt::format(" {:>7} | {:>7} | {:>7} | {:>4} |\n", "", "", "", 0);
    }
  }
  if (const auto common = commonShiftOf(drawing, map)) {
    text += fmt::format(
        "\n{} buildings together: x {:+.2f} m (sigma {:.2f}), y {:+.2f} m (sigma {:.2f}), turned "
        "{:+.2f} deg (sigma {:.2f}); each of its own {:.2f} m\n",
        common->buildings, common->shift.x(), common->shift_sigma.x(), common->shift.y(),
        common->shift_sigma.y(), toDegrees(common->turn), toDegrees(common->turn_sigma),
        common->own);
  }
  return text;
}

std::string runSummaryJson(const Map& drawing, const RunSession& session) {
  using Json = nlohmann::ordered_json;
  const Pose2 pose = session.trajectory().back().pose;
  Json json = {{"observations", session.frames().size()},
               {"skipped", session.skipped().size()},
               {"pose", {{"x", pose.x}, {"y", pose.y}, {"heading_deg", toDegrees(pose.heading)}}},
               {"buildings", Json::array()},
               {"warnings", Json::array()}};
  const Map map = session.refinedMap();
  if (const auto common = commonShiftOf(drawing, map)) {
    json["common_shift"] = {{"buildings", common->buildings},
                            {"x", common->shift.x()},
                            {"y", common->shift.y()},
                            {"sigma_x", common->shift_sigma.x()},
                            {"sigma_y", common->shift_sigma.y()},
                            {"turn_deg", toDegrees(common->turn)},
                            {"sigma_turn_deg", toDegrees(common->turn_sigma)},
                            {"own_m", common->own}};
  }
  for (const Building& building : map.buildings) {
    const Rectangle box = building.box();
    Json one = {{"id", building.id},   {"x", box.centre.x()},
                {"y", box.centre.y()}, {"width", box.width},
                {"depth", box.depth},  {"heading_deg", toDegrees(box.heading)}};
    if (const auto& estimate = building.estimate) {
      one["estimate"] = {{"sigma_x", estimate->sigma_x},
                         {"sigma_y", estimate->sigma_y},
                         {"sigma_width", estimate->sigma_width},
                         {"observations", estimate->observations}};
    }
    json["buildings"].push_back(std::move(one));
  }
  for (const RunWarning& warning : session.warnings()) {
    json["warnings"].push_back({{"code", warning.code}, {"message", warning.message}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace handmap
