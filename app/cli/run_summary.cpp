#include "app/cli/run_summary.h"

#include <algorithm>

#include <fmt/format.h>

namespace handmap {

std::string runSummary(const RunSession& session) {
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
  return text;
}

}  // namespace handmap
