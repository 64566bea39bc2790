#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/image_truth_writer.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/rendering/rendered_source.h"
#include "core/simulation/feature_source.h"
#include "core/simulation/misdrawn.h"

namespace handmap {

namespace {

enum class Scenery { TwoRows, Campus, Loop, Street, Quarter, Terraces };

struct SimulateArguments {
  std::string world;
  Scenery scene = Scenery::TwoRows;
  std::uint64_t seed = 1;
  double sigma_m = 5.0;
  double view_deg = 360.0;
  bool laser = false;
  bool clutter = false;
  bool rough = false;
  bool sheds = false;
  bool images = false;
  bool moving = false;
  double step_m = 1.0;
  std::optional<double> features;  ///< in a frame
  std::optional<double> joined_m;
  int rounds = 1;
  double odometry_scale = 1.0;
  double odometry_turn_rad_m = 0.0;
  Misdrawing misdrawing;
  bool labels = false;
  RenderOptions rendering;
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
  switch (arguments.scene) {
    case Scenery::Campus:
      return campusWorld(arguments.seed);
    case Scenery::Loop:
      return loopWorld(arguments.seed);
    case Scenery::Street:
      return streetWorld(arguments.seed);
    case Scenery::Quarter:
      return quarterWorld(arguments.seed);
    case Scenery::Terraces:
      return terraceWorld(arguments.seed);
    case Scenery::TwoRows:
      break;
  }
  return twoRowWorld(arguments.seed);
}

World furnishedWorldOf(const SimulateArguments& arguments) {
  World world = worldOf(arguments);
  if (arguments.clutter && world.things.empty()) {
    world = furnished(std::move(world), arguments.seed);
  }
  if (arguments.sheds) world = withSheds(std::move(world), arguments.seed);
  if (arguments.rough && world.walls.empty()) world = rough(std::move(world), arguments.seed);
  return world;
}

SimulationOptions sensorOf(const SimulateArguments& arguments, const World& world) {
  if (arguments.features) return drivingPastFeatures(arguments.step_m);
  if (arguments.images)
    return arguments.moving ? atStep({}, arguments.step_m) : SimulationOptions{};
  SimulationOptions options =
      arguments.laser ? laserOnTheMove(arguments.step_m) : SimulationOptions{};
  options.view_rad = toRadians(arguments.view_deg);
  return arguments.laser && !world.walls.empty() ? losingReturns(options) : options;
}

std::unique_ptr<ObservationSource> sourceOf(const SimulateArguments& arguments,
                                            const World& world) {
  SimulationOptions options = sensorOf(arguments, world);
  options.rounds = arguments.rounds;
  options.odometry_scale = arguments.odometry_scale;
  options.odometry_turn_rad_m = arguments.odometry_turn_rad_m;
  if (arguments.features) {
    const FeatureOptions features{*arguments.features, arguments.joined_m.value_or(0.0)};
    return simulateFeatures(world, options, features, arguments.seed);
  }
  if (!arguments.images) return simulate(world, options, arguments.seed);
  TruthListener listener;
  if (arguments.labels) {
    listener = [folder = arguments.out](const Observation& observation,
                                        const std::vector<ImageTruth>& truths) {
      writeImageTruth(folder, observation, truths);
    };
  }
  return renderedSource(world, options, arguments.rendering,
                        arguments.moving ? Looking::Ahead : Looking::Around, arguments.seed,
                        std::move(listener));
}

/// Returns whether it came to its end.
bool record(ObservationSource& source, const std::string& out) {
  const Interrupt interrupt;
  RecordingWriter writer(out, source.info());
  Progress progress(source.info().observations);
  int done = 0;
  for (const StampedPose& truth : source.info().truth) {
    progress.update(done, 0.0);
    if (const auto observation = source.next()) writer.add(*observation, truth.pose);
    ++done;
    if (interrupt.requested()) {
      progress.message(fmt::format("interrupted, the recording ends after {} frames", done));
      return false;
    }
  }
  progress.finish(done);
  return true;
}

int simulateCommand(const SimulateArguments& arguments) {
  checkOutputFolder(arguments.out);
  const World world = furnishedWorldOf(arguments);
  const Map truth = world.drawable();
  const Map sketch = misdrawn(perturbed(truth, arguments.sigma_m, arguments.seed), truth,
                              arguments.misdrawing, arguments.seed);
  const auto source = sourceOf(arguments, world);
  if (!record(*source, arguments.out)) return Interrupt::kExitStatus;
  const std::filesystem::path folder = arguments.out;
  writeMap(truth, folder / "truth.handmap");
  writeMap(sketch, folder / "sketch.handmap");
  fmt::print("{}: {} observations, truth.handmap and sketch.handmap of {} buildings\n",
             arguments.out, source->info().observations, sketch.buildings.size());
  return 0;
}

void addImageOptions(CLI::App& command, SimulateArguments& a) {
  RenderOptions& r = a.rendering;
  CLI::Option* images =
      command.add_flag("--images", a.images, "Rendered stereo images in place of range points")
          ->option_text("Excludes: --view --laser --features");
  const auto only = [&](CLI::Option* option) { option->needs(images); };
  only(command.add_flag("--moving", a.moving, "Look ahead, not around at stops"));
  images->excludes("--laser");
  only(command.add_flag("--labels", a.labels,
                        "Also labels/ (classes of CamVid) and depth/ (centimetres)"));
  only(command.add_flag("--colour", r.colour, "In colour"));
  only(addNumber(command, "--width", r.width, 64, 4096, "Pixels"));
  only(addNumber(command, "--height", r.height, 64, 4096, "Pixels"));
  only(addNumber(command, "--fov", r.horizontal_fov_deg, 10, 150, "Angle of view, degrees"));
  only(addNumber(command, "--baseline", r.baseline_m, 0.01, 5, "Of the stereo camera, metres"));
  only(addNumber(command, "--sun", r.light.sun, 0, 3, "0 overcast, 1 clear, 3 walls saturate"));
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
  addChoice(*command, "--scene", a.scene,
            {{"two-rows", Scenery::TwoRows},
             {"campus", Scenery::Campus},
             {"loop", Scenery::Loop},
             {"street", Scenery::Street},
             {"quarter", Scenery::Quarter},
             {"terraces", Scenery::Terraces}},
            "A made-up world, in place of --world")
      ->excludes(world);
  addSeed(*command, a.seed, "Of the world, its noise and the sketch");
  addNumber(*command, "--sigma", a.sigma_m, 0.01, 1000, "Error of the sketch, metres");
  addMisdrawing(*command, a.misdrawing);
  command->add_flag("--clutter", a.clutter, "Parked cars and hedges; the street has them anyway");
  command->add_flag("--rough", a.rough,
                    "As real places: fences, bicycles, ragged plants, recesses; the quarter is so");
  command->add_flag("--sheds", a.sheds,
                    "Along the fronts parked cars, and sheds that nobody draws");
  addNumber(*command, "--rounds", a.rounds, 1, 100,
            "Drive so often: round again, or forward and back by turns");
  const auto drift = [&a](double percent, double degrees) {
    a.odometry_scale = 1.0 + percent / 100.0;
    a.odometry_turn_rad_m = toRadians(degrees);
  };
  addPair(*command, "--drift", drift, 50, 10, "PERCENT,DEG",
          "Bias of the odometry: distances too long, and a turn a metre");
  CLI::Option* view = addNumber(*command, "--view", a.view_deg, 10, 360,
                                "Of the range sensor, around straight ahead, degrees");
  command->add_flag("--laser", a.laser, "A planar laser on the move, as precise as real ones");
  CLI::Option* features =
      addNumber(*command, "--features", a.features, 1, 1000,
                "Tracked points a frame in place of rays, as a poor visual front end has");
  addNumber(*command, "--joined", a.joined_m, 1, 1000,
            "A frame has the points of so many metres, joined by the odometry")
      ->needs(features);
  addNumber(*command, "--step", a.step_m, 0.1, 100,
            "From view to view with --laser, --features or --moving, metres");
  addImageOptions(*command, a);
  view->excludes("--images");
  for (const char* other : {"--laser", "--view", "--images"}) features->excludes(other);
  command->add_option("--out", a.out, "A new folder (required)")->required()->option_text("DIR");
}

}  // namespace handmap
