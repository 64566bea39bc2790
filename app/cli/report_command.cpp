#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/report/report.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMostReportBytes = 1u << 30;

struct ReportArguments {
  std::string map;
  std::string refined;
  std::string run;
  std::string trajectory;
  std::string truth;
  std::string recording;
  std::string out;
};

int report(const ReportArguments& a) {
  checkOutputFiles({a.out}, {a.map, a.refined, a.run, a.trajectory, a.truth});
  const std::string ending = std::filesystem::path(a.out).extension().string();
  if (ending != ".html" && ending != ".csv" && ending != ".tex") {
    throw Error(ErrorCode::Usage,
                fmt::format("--out: found {}, expected NAME.html, .csv or .tex", a.out));
  }
  ReportInputs inputs;
  inputs.refined = readMap(a.refined);
  if (ending == ".csv") {
    writeFileAtomically(a.out, tolerancesCsv(inputs.refined));
    return 0;
  }
  if (ending == ".tex") {
    writeFileAtomically(a.out, tolerancesLatex(inputs.refined));
    return 0;
  }
  if (a.map.empty() || a.run.empty()) {
    throw Error(ErrorCode::Usage, "--map and --report: expected both for a page",
                "handmap-cli report --help");
  }
  inputs.drawing = readMap(a.map);
  inputs.run = readFile(a.run, kMostReportBytes);
  inputs.run_file = a.run;
  if (!a.trajectory.empty()) inputs.trajectory = readTum(a.trajectory).poses();
  if (!a.truth.empty()) inputs.truth = readMap(a.truth);
  if (!a.recording.empty()) inputs.recording = openRecording(a.recording);
  writeFileAtomically(a.out, reportHtml(inputs));
  return 0;
}

}  // namespace

void addReportCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<ReportArguments>();
  ReportArguments& a = *arguments;
  CLI::App* command =
      app.add_subcommand("report", "Make a page of a run that anybody can open, or a table");
  command->callback([&chosen, arguments] { chosen = [arguments] { return report(*arguments); }; });
  const auto file = [command](const char* name, std::string& value, const char* what,
                              const char* form) {
    return command->add_option(name, value, what)->option_text(form);
  };
  file("--map", a.map, "The drawing", "M.handmap");
  file("--refined", a.refined, "The corrected map, of run --out (required)", "R.handmap")
      ->required();
  file("--report", a.run, "What run --report wrote", "report.json");
  file("--trajectory", a.trajectory, "Where the robot was, of run --trajectory", "FILE.tum");
  file("--truth", a.truth, "A true map, to be drawn beside", "T.handmap");
  file("--recording", a.recording, "For pictures on the way", "DIR");
  file("--out", a.out,
       "The page (.html, which refers to nothing outside), or how sure each wall is (.csv, .tex) "
       "(required)",
       "FILE")
      ->required();
}

}  // namespace handmap
