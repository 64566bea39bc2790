#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/sketch_inputs.h"
#include "core/base/error.h"
#include "core/sketch_study/people_report.h"

namespace handmap {

namespace {

struct SketchStatsArguments {
  SketchInputs inputs;
  std::uint64_t seed = 1;
  bool json = false;
};

int tellStatistics(const SketchStatsArguments& a) {
  std::vector<DrawnErrors> drawings;
  for (const Sketch& sketch : readSketches(a.inputs)) {
    const auto errors = drawnErrors(sketch);
    if (!errors) {
      throwBadInput(sketch.name, "", "fewer than three places of the true map", "three or more");
    }
    drawings.push_back(*errors);
  }
  const PeopleReport report = peopleReport(std::move(drawings), a.seed);
  fmt::print("{}", a.json ? formatJson(report) : formatText(report));
  return 0;
}

}  // namespace

void addSketchStatsCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<SketchStatsArguments>();
  SketchStatsArguments& a = *arguments;
  CLI::App* command = app.add_subcommand(
      "sketch-stats", "Tell how people draw, from drawings of places that are known");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return tellStatistics(*arguments); }; });
  addSketchInputs(*command, a.inputs);
  addSeed(*command, a.seed, "Of the draws that the intervals come from");
  command->add_flag("--json", a.json, "For programs");
}

}  // namespace handmap
