#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/simulation/drawn_by_people.h"
#include "core/simulation/redrawn.h"
#include "core/simulation/world.h"

namespace handmap {

namespace {

struct PerturbArguments {
  std::string map;
  std::optional<double> sigma_m;
  Like like = Like::Sigma;
  Redrawing redrawing;
  Misdrawing misdrawing;
  std::uint64_t seed = 1;
  std::string out;
};

Map drawingOf(const Map& outlined, const PerturbArguments& arguments) {
  if (arguments.like == Like::Sigma) {
    return perturbed(outlined, *arguments.sigma_m, arguments.seed);
  }
  PeopleErrors errors;
  if (arguments.sigma_m) errors.position = *arguments.sigma_m / extentOf(outlined);
  return drawnByPeople(outlined, errors, arguments.seed);
}

int perturb(const PerturbArguments& arguments) {
  if (arguments.like == Like::Sigma && !arguments.sigma_m) {
    throw Error(ErrorCode::Usage, "--sigma is required", "handmap-cli perturb --help");
  }
  checkOutputFiles({arguments.out}, {arguments.map});
  const Map truth = readMap(arguments.map);
  const Map outlined = redrawn(truth, arguments.redrawing, arguments.seed);
  writeMap(misdrawn(drawingOf(outlined, arguments), truth, arguments.misdrawing, arguments.seed),
           arguments.out);
  return 0;
}

}  // namespace

void addPerturbCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<PerturbArguments>();
  PerturbArguments& a = *arguments;
  CLI::App* command = app.add_subcommand("perturb", "Make a map as one would remember it");
  command->callback([&chosen, arguments] { chosen = [arguments] { return perturb(*arguments); }; });
  command->add_option("--map", a.map, "The true map (required)")
      ->required()
      ->option_text("TRUTH.handmap");
  addNumber(*command, "--sigma", a.sigma_m, 0.01, 1000,
            "Error of centres and sizes, metres; with --like people of centres, and not required");
  addChoice(*command, "--like", a.like, {{"sigma", Like::Sigma}, {"people", Like::People}},
            "Errors of every building by itself, or as people draw");
  addNumber(*command, "--corners", a.redrawing.corners_m, 0, 100,
            "Error of each corner of an outline by itself, metres");
  addNumber(*command, "--simplify", a.redrawing.simplify_m, 0, 100,
            "Annexes and recesses less deep are left out, metres");
  addMisdrawing(*command, a.misdrawing);
  addSeed(*command, a.seed, "Of the random numbers");
  command->add_option("--out", a.out, "The sketch (required)")
      ->required()
      ->option_text("SKETCH.handmap");
}

}  // namespace handmap
