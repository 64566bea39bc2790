#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/sketch_inputs.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/sketch_study/figures.h"

namespace handmap {

namespace {

struct FiguresArguments {
  SketchInputs inputs;
  std::vector<std::string> corrected;
  std::string out;
};

int tellFigures(const FiguresArguments& a) {
  if (!a.corrected.empty() && a.corrected.size() != a.inputs.drawings.size()) {
    throw Error(ErrorCode::Usage, fmt::format("--corrected: found {}, expected one for each of the "
                                              "{} drawings",
                                              a.corrected.size(), a.inputs.drawings.size()));
  }
  std::vector<std::string> read = a.inputs.drawings;
  read.insert(read.end(), a.inputs.references.begin(), a.inputs.references.end());
  read.insert(read.end(), a.corrected.begin(), a.corrected.end());
  checkOutputFiles({a.out}, read);
  const std::vector<Sketch> drawn = readSketches(a.inputs);
  std::vector<Sketch> corrected;
  if (!a.corrected.empty()) corrected = readSketches(a.inputs, a.corrected);
  std::vector<SketchFigures> rows;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    rows.push_back(figuresOf(drawn[i]));
    if (corrected.empty()) continue;
    rows.push_back(figuresOf(corrected[i], "corrected"));
    rows.back().drawing = drawn[i].name;
  }
  const std::string table = figureTable(rows);
  if (a.out.empty()) {
    fmt::print("{}", table);
  } else {
    writeFileAtomically(a.out, table);
  }
  return 0;
}

}  // namespace

void addFiguresCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<FiguresArguments>();
  FiguresArguments& a = *arguments;
  CLI::App* command =
      app.add_subcommand("figures", "Tell the figures of sketch-map research, a row a drawing");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return tellFigures(*arguments); }; });
  addSketchInputs(*command, a.inputs);
  command->add_option("--corrected", a.corrected, "What a run made of each drawing: a second row")
      ->option_text("MAP")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--csv", a.out, "The table; without it, on stdout")->option_text("OUT.csv");
}

}  // namespace handmap
