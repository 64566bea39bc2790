#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "core/base/text.h"
#include "core/geodata/geo_map.h"
#include "core/geodata/geo_writer.h"
#include "core/geodata/robot_map.h"
#include "core/map/map_io.h"
#include "core/map/map_limits.h"
#include "core/map/references.h"
#include "core/map_match/grid_place.h"
#include "core/report/plan.h"

namespace handmap {

namespace {

struct ConvertArguments {
  std::string in;
  std::string onto;
  std::string out;
};

bool isDrawing(const std::filesystem::path& path) { return path.extension() == ".handmap"; }

bool isPlan(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return !ending.empty() &&
         std::ranges::find(planEndings(), ending.substr(1)) != planEndings().end();
}

/// A robot's map becomes a picture under the drawing.
int layOnto(const ConvertArguments& arguments) {
  const std::filesystem::path onto = arguments.onto;
  checkOutputFiles({arguments.out}, {arguments.in});
  Map drawing = readMap(onto);
  const RobotGrid grid = readRobotGrid(arguments.in);
  const auto place = placeOf(grid.ground, drawing);
  if (!place) {
    throwBadInput(arguments.in, "", "a map without anything straight", "walls of a place");
  }
  if (drawing.underlays.size() >= kMaxUnderlays) {
    throwBadInput(arguments.onto, "underlays", std::to_string(drawing.underlays.size()),
                  fmt::format("fewer than {}", kMaxUnderlays));
  }
  const Pose2& pose = place->pose;
  fmt::print(
      "x_m: {:.2f}\ny_m: {:.2f}\nturn_deg: {:.2f}\nfits: {}\nwalls_there: {:.2f}\n"
      "median_m: {:.2f}\nninety_percent_m: {:.2f}\nscale: {:.3f}\nscale_sigma: {:.3f}\n",
      pose.x, pose.y, toDegrees(pose.heading), place->fits ? "yes" : "no", place->supported,
      place->median_m, place->most_m, place->scale, place->scale_sigma);
  if (place->other) {
    fmt::print("or_x_m: {:.2f}\nor_y_m: {:.2f}\nor_turn_deg: {:.2f}\n", place->other->x,
               place->other->y, toDegrees(place->other->heading));
  }
  moveReferences(drawing, onto, arguments.out);
  Underlay underlay = underlayOf(grid, pose);
  underlay.image = referenceFrom(arguments.out, std::filesystem::absolute(grid.image));
  drawing.underlays.push_back(std::move(underlay));
  writeMap(drawing, arguments.out);
  return 0;
}

void tellCoarseCells(const Map& map, const std::string& file) {
  const double cell_m = isMapServer(file) ? robotMapCell(map, file) : kRobotMapCell_m;
  if (cell_m == kRobotMapCell_m) return;
  fmt::print(stderr,
             "{}: in cells of {} m: it is too large a place for a picture in cells of {} m\n", file,
             cell_m, kRobotMapCell_m);
}

int convert(const ConvertArguments& arguments) {
  if (!arguments.onto.empty()) return layOnto(arguments);
  const bool from_drawing = isDrawing(arguments.in);
  if (from_drawing == isDrawing(arguments.out)) {
    throw Error(ErrorCode::Usage,
                fmt::format("{} to {}: one of them is to be a drawing (.handmap)", arguments.in,
                            arguments.out),
                "handmap-cli convert --help");
  }
  checkOutputFiles({arguments.out}, {arguments.in});
  if (from_drawing) {
    const Map map = readMap(arguments.in);
    if (isPlan(arguments.out)) {
      writeFileAtomically(arguments.out, formatPlan(map, arguments.out));
      return 0;
    }
    writeGeoMap(map, arguments.out);
    tellCoarseCells(map, arguments.out);
    return 0;
  }
  if (std::filesystem::path(arguments.in).extension() == ".yaml") {
    writeMap(readRobotMap(arguments.in), arguments.out);
    return 0;
  }
  const GeoMap geo = readGeoMap(arguments.in);
  if (geo.left_out > 0)
    fmt::print(stderr, "{}: {} outlines are left out: they cross themselves or are too large\n",
               arguments.in, geo.left_out);
  writeMap(geo.map, arguments.out);
  return 0;
}

}  // namespace

void addConvertCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<ConvertArguments>();
  ConvertArguments& a = *arguments;
  CLI::App* command = app.add_subcommand(
      "convert", "Make a drawing of a public or robot map, or such a map of a drawing");
  command->callback([&chosen, arguments] { chosen = [arguments] { return convert(*arguments); }; });
  command
      ->add_option("in", a.in,
                   "GeoJSON, OpenStreetMap XML, GeoPackage, Shapefile, KML, GML, DXF (metres), a "
                   "map of map_server (.yaml); or a drawing")
      ->required()
      ->option_text("IN");
  command
      ->add_option("out", a.out,
                   "The drawing (.handmap); or of one GeoJSON, OpenStreetMap XML, KML, GeoPackage "
                   "(these need a georeference), DXF, a map of map_server (.yaml and .pgm), for "
                   "fleets Open-RMF's NAME.building.yaml and the reference coordinates of the "
                   "robot's map under it, NAME.fleet.yaml; or the plan with scale bar and legend "
                   "(.pdf, .svg, .png)")
      ->required()
      ->option_text("OUT");
  command
      ->add_option(
          "--onto", a.onto,
          "A drawing of the same place: the robot's map (.yaml) is laid on it, where it is "
          "found to lie, as a picture underneath")
      ->option_text("MAP.handmap");
}

}  // namespace handmap
