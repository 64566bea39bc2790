#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "core/geodata/geo_map.h"
#include "core/geodata/geo_writer.h"
#include "core/geodata/robot_map.h"
#include "core/map/map_io.h"

namespace handmap {

namespace {

struct ConvertArguments {
  std::string in;
  std::string out;
};

bool isDrawing(const std::filesystem::path& path) { return path.extension() == ".handmap"; }

int convert(const ConvertArguments& arguments) {
  const bool from_drawing = isDrawing(arguments.in);
  if (from_drawing == isDrawing(arguments.out)) {
    throw Error(ErrorCode::Usage,
                fmt::format("{} to {}: one of them is to be a drawing (.handmap)", arguments.in,
                            arguments.out),
                "handmap-cli convert --help");
  }
  checkOutputFiles({arguments.out}, {arguments.in});
  if (from_drawing) {
    writeGeoMap(readMap(arguments.in), arguments.out);
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
      ->add_option(
          "in", a.in,
          "GeoJSON, OpenStreetMap XML, GeoPackage, Shapefile, KML, GML, a map of map_server "
          "(.yaml); or a drawing")
      ->required()
      ->option_text("IN");
  command
      ->add_option("out", a.out,
                   "The drawing (.handmap); or of one GeoJSON, OpenStreetMap XML, KML, GeoPackage "
                   "(these need a "
                   "georeference), DXF, a map of map_server (.yaml and .pgm)")
      ->required()
      ->option_text("OUT");
}

}  // namespace handmap
