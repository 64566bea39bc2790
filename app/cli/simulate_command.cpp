#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/simulation/simulated_source.h"

namespace handmap {

namespace {

enum class Scene { TwoRows, Campus };

struct SimulateArguments {
  std::string world;
  Scene scene = Scene::TwoRows;
  std::uint64_t seed = 1;
  double sigma_m = 5.0;
  bool images = false;
  std::string out;
};

World worldOf(const SimulateArguments& arguments) {
  if (!arguments.world.empty()) {
    const Map map = readMap(arguments.world);
    try {
      return worldFromMap(map, arguments.seed);
    } catch (const Error& error) {
      throw Error(error.code(), arguments.world + ": " + error.what(), error.hint());
    }
  }
  return arguments.scene == Scene::Campus ? campusWorld(arguments.seed)
                                          : twoRowWorld(arguments.seed);
}

int simulateCommand(const SimulateArguments& arguments) {
  if (arguments.images) {
    throw Error(ErrorCode::Usage, "--images: rendered images are not in this version",
                "leave it out: the recording then holds range points");
  }
  checkOutputFolder(arguments.out);
  const World world = worldOf(arguments);
  const auto source = simulate(world, {}, arguments.seed);
  RecordingWriter writer(arguments.out, source->info());
  for (const StampedPose& truth : source->info().truth) {
    if (const auto observation = source->next()) writer.add(*observation, truth.pose);
  }
  const std::filesystem::path folder = arguments.out;
  const Map sketch = perturbed(world.map, arguments.sigma_m, arguments.seed);
  writeMap(world.map, folder / "truth.handmap");
  writeMap(sketch, folder / "sketch.handmap");
  fmt::print("{}: {} observations, truth.handmap and sketch.handmap of {} buildings\n",
             arguments.out, source->info().observations, sketch.buildings.size());
  return 0;
}

}  // namespace

void addSimulateCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<SimulateArguments>();
  SimulateArguments& a = *arguments;
  CLI::App* command =
      app.add_subcommand("simulate", "Make a recording, its true map and a sketch of that");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return simulateCommand(*arguments); }; });
  CLI::Option* world = command->add_option("--world", a.world, "A map with a route or a start");
  world->option_text("W.handmap");
  addChoice(*command, "--scene", a.scene, {{"two-rows", Scene::TwoRows}, {"campus", Scene::Campus}},
            "A made-up world, in place of --world")
      ->excludes(world);
  addSeed(*command, a.seed, "Of the world, its noise and the sketch");
  addNumber(*command, "--sigma", a.sigma_m, 0.01, 1000, "Error of the sketch, metres");
  command->add_flag("--images", a.images, "Stereo images in place of range points");
  command->add_option("--out", a.out, "A new folder (required)")->required()->option_text("DIR");
}

}  // namespace handmap
