#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/paper/sheet.h"

namespace handmap {

namespace {

struct SheetArguments {
  std::string map;
  bool over = false;
  double width_m = 200.0;
  std::string out;
};

int sheetCommand(const SheetArguments& arguments) {
  checkOutputFiles({arguments.out}, {arguments.map});
  if (arguments.map.empty()) {
    writeFileAtomically(arguments.out, sheetPdf(emptySheet(arguments.width_m)));
    return 0;
  }
  const Map map = readMap(arguments.map);
  writeFileAtomically(arguments.out,
                      arguments.over ? overprintPdf(map) : sheetPdf(sheetFor(map), &map));
  return 0;
}

}  // namespace

void addSheetCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<SheetArguments>();
  SheetArguments& a = *arguments;
  CLI::App* command =
      app.add_subcommand("sheet", "Print a sheet to draw on, whose photo tells scale and start");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return sheetCommand(*arguments); }; });
  CLI::Option* map = command->add_option("--map", a.map, "A map to print on it, to draw over");
  map->option_text("MAP.handmap");
  command
      ->add_flag("--over", a.over, "The map alone, to be printed on the paper that it was drawn on")
      ->needs(map);
  addNumber(*command, "--width", a.width_m, 1, 4800, "Of the place to be drawn, metres")
      ->excludes(map);
  command->add_option("--out", a.out, "The sheet, of A4 (required)")
      ->required()
      ->option_text("SHEET.pdf");
}

}  // namespace handmap
