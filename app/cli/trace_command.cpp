#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/map/references.h"
#include "core/paper/traced_map.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace {

struct TraceArguments {
  std::string photo;
  std::optional<double> width_m;
  std::optional<double> page_width_m;
  std::string on;
  std::string out;
};

constexpr auto kHelp = "handmap-cli trace --help";

std::string pictureFile(const TraceArguments& arguments) {
  return std::filesystem::path(arguments.out).replace_extension().string() + "-paper.png";
}

/// The map that belongs to a sheet, its start known.
Map mapOfSheet(const Trace& trace, const TraceArguments& arguments, PagePlace& place) {
  const SheetCode code = *trace.page.sheet;
  if (code.of_map != !arguments.on.empty()) {
    throw Error(ErrorCode::Usage,
                code.of_map ? "a map is printed on this sheet: --on is required"
                            : "--on: no map is printed on this sheet",
                kHelp);
  }
  if (!code.of_map) {
    const Sheet sheet = emptySheet(code);
    place = placeOf(trace.page, sheet);
    Map map = mapOf(trace, place);
    map.start = sheet.start;
    return map;
  }
  Map printed = readMap(arguments.on);
  const Sheet sheet = sheetOf(code).value_or(sheetFor(printed));
  if (sheet.code.square_m != code.square_m) {
    throwBadInput(arguments.photo, "", fmt::format("squares of {} m", code.square_m),
                  fmt::format("{} m, as the sheet of {} has", sheet.code.square_m, arguments.on));
  }
  moveReferences(printed, arguments.on, arguments.out);
  place = placeOf(trace.page, sheet);
  return drawnOver(std::move(printed), mapOf(trace, place));
}

Map tracedMap(const Trace& trace, const TraceArguments& arguments, PagePlace& place) {
  if (arguments.width_m || arguments.page_width_m) {
    place = arguments.width_m ? placeOfDrawing(trace, sureShapes(trace), *arguments.width_m)
                              : placeOfPage(trace.page, *arguments.page_width_m);
    return mapOf(trace, place);
  }
  if (trace.page.sheet) return mapOfSheet(trace, arguments, place);
  throw Error(ErrorCode::Usage,
              "--width is required: this is no printed sheet, so that nothing tells the scale",
              kHelp);
}

int traceCommand(const TraceArguments& arguments) {
  const std::string picture = pictureFile(arguments);
  checkOutputFiles({arguments.out, picture}, {arguments.photo, arguments.on});
  const cv::Mat photo = readPhoto(arguments.photo, kPhotoSide_px);
  const Trace trace = traced(photo);
  const std::size_t sure = sureShapes(trace).size();
  if (sure == 0) {
    const std::string trouble = troubleWith(photo);
    throwBadInput(arguments.photo, "",
                  trouble.empty() ? "no closed shapes" : "no closed shapes: " + trouble,
                  "outlines of buildings, drawn closed with a pen");
  }
  PagePlace place;
  Map map = tracedMap(trace, arguments, place);
  map.underlays.push_back(underlayOf(trace.page, place, referenceFrom(arguments.out, picture)));
  writePng(trace.page.image, picture);
  writeMap(map, arguments.out);
  fmt::print("{}: {} closed shapes taken for buildings, {} left out\n", arguments.out, sure,
             trace.shapes.size() - sure);
  if (!arguments.on.empty() && isPlaceUnread(trace)) {
    fmt::print("{}: the code on the sheet cannot be read: it lies where {} is printed now\n",
               arguments.out, arguments.on);
  }
  if (!map.start) fmt::print("{}: the start is not known yet\n", arguments.out);
  return 0;
}

}  // namespace

void addTraceCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<TraceArguments>();
  TraceArguments& a = *arguments;
  CLI::App* command = app.add_subcommand("trace", "Make a drawing of a photo of one on paper");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return traceCommand(*arguments); }; });
  command->add_option("photo", a.photo, "PNG or JPEG, of a photo or a scan")
      ->required()
      ->option_text("PHOTO");
  CLI::Option* width =
      addNumber(*command, "--width", a.width_m, 1, 1e5,
                "From the leftmost building to the rightmost, metres; a printed sheet tells it");
  addNumber(*command, "--page-width", a.page_width_m, 1, 1e5, "The same of the whole page")
      ->excludes(width);
  command->add_option("--on", a.on, "The map that was printed on the sheet")
      ->option_text("MAP.handmap")
      ->excludes(width)
      ->excludes("--page-width");
  command
      ->add_option("--out", a.out,
                   "The drawing; the page goes beside it as NAME-paper.png (required)")
      ->required()
      ->option_text("DRAWING.handmap");
}

}  // namespace handmap
