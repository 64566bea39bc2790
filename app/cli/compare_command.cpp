#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/evaluation/comparison_report.h"
#include "core/map/map_io.h"

namespace handmap {

namespace {

struct CompareArguments {
  std::string map;
  std::string truth;
  std::string only;
  std::string trajectory;
  std::string true_trajectory;
  bool json = false;
};

std::vector<std::string> idsOf(const std::string& list, const Map& truth) {
  if (list.empty()) return {};
  std::vector<std::string> ids;
  for (const std::string_view field : splitFields(list, ',')) {
    ids.emplace_back(field);
    if (truth.find(ids.back()) == nullptr) {
      throw Error(
          ErrorCode::Usage,
          fmt::format("--only: found \"{}\", expected ids of buildings of the truth", ids.back()));
    }
  }
  return ids;
}

TrajectoryError trajectoryError(const CompareArguments& arguments) {
  const Trajectory estimate = readTum(arguments.trajectory);
  const auto error = compareTrajectories(estimate.poses(), readTum(arguments.true_trajectory));
  if (!error) {
    throwBadInput(arguments.trajectory, "", "no time in common with " + arguments.true_trajectory,
                  "poses of the same drive");
  }
  return *error;
}

int compare(const CompareArguments& arguments) {
  const Map map = readMap(arguments.map);
  const Map truth = readMap(arguments.truth);
  ComparisonReport report;
  report.only = idsOf(arguments.only, truth);
  report.as_it_is = compareMaps(map, truth, false);
  report.aligned = compareMaps(map, truth, true);
  if (report.as_it_is.buildings.empty()) {
    throwBadInput(arguments.map, "buildings", "no id of " + arguments.truth, "the same ids");
  }
  if (!arguments.trajectory.empty()) report.trajectory = trajectoryError(arguments);
  fmt::print("{}", arguments.json ? formatJson(report) : formatText(report));
  return 0;
}

}  // namespace

void addCompareCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<CompareArguments>();
  CompareArguments& a = *arguments;
  CLI::App* command = app.add_subcommand("compare", "Tell how far a map is from the truth");
  command->callback([&chosen, arguments] { chosen = [arguments] { return compare(*arguments); }; });
  command->add_option("map", a.map, "The map to be judged")->required()->option_text("A.handmap");
  command->add_option("truth", a.truth, "The true map")->required()->option_text("TRUTH.handmap");
  command->add_option("--only", a.only, "Ids of buildings, between commas")
      ->option_text("L4,L5,...");
  CLI::Option* trajectory = command->add_option("--trajectory", a.trajectory, "Poses to be judged");
  CLI::Option* true_trajectory =
      command->add_option("--truth", a.true_trajectory, "The true poses, for --trajectory");
  trajectory->needs(true_trajectory)->option_text("T.tum");
  true_trajectory->needs(trajectory)->option_text("truth.tum");
  command->add_flag("--json", a.json, "For programs");
}

}  // namespace handmap
