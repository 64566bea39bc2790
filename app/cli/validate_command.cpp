#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/cli/commands.h"
#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "app/cli/repeats.h"
#include "core/map/issues.h"
#include "core/map/map_io.h"
#include "core/map/references.h"
#include "core/plausibility/drawing.h"
#include "core/plausibility/plausibility.h"
#include "core/recording/validation.h"
#include "core/rig/rig.h"

namespace handmap {

namespace {

namespace fs = std::filesystem;

int validateRecording(const std::string& path) {
  const Recording recording = openRecording(path);
  const int status = complain(doubtsOf(recording));
  const std::vector<std::string> problems = problemsOf(recording);
  Repeats repeats;
  for (const std::string& problem : problems) {
    if (repeats.isNews(problem)) complain(Error(ErrorCode::BadInput, problem));
  }
  fmt::print(stderr, "{}", repeats.counted());
  if (!problems.empty() || status != 0) return static_cast<int>(ErrorCode::BadInput);
  fmt::print("ok: {}: recording of {} frames\n", path, recording.rows.size());
  return 0;
}

std::string devicesOf(const Rig& rig) {
  std::vector<std::string> names;
  if (rig.scanner) names.emplace_back("a scanner");
  if (rig.camera) names.emplace_back("a camera");
  if (rig.head) names.emplace_back("a head");
  return names.empty() ? "no sensor" : fmt::format("{}", fmt::join(names, ", "));
}

int validateFile(const std::string& path, Outside outside) {
  if (fs::path(path).extension() == ".tum") {
    fmt::print("ok: {}: trajectory of {} poses\n", path, readTum(path).poses().size());
  } else if (fs::path(path).extension() == ".json") {
    fmt::print("ok: {}: rig of {}\n", path, devicesOf(readRig(path)));
  } else {
    const Map map = readMap(path);
    checkReferences(map, path, outside);
    const int status = complain(doubtsOfDrawing(map, path));
    if (status != 0) return status;
    fmt::print("ok: {}: map of {} buildings\n", path, map.buildings.size());
    for (const Issue& issue : findIssues(map))
      fmt::print(stderr, "handmap-cli: note: {}: {}\n", path, inWords(issue));
  }
  return 0;
}

/// Goes on after a problem, so that one call tells them all.
int validate(const std::vector<std::string>& paths, Outside outside) {
  int status = 0;
  for (const std::string& path : paths) {
    try {
      std::error_code error;
      const bool folder = fs::is_directory(path, error);
      status = std::max(status, folder ? validateRecording(path) : validateFile(path, outside));
    } catch (const Error& error) {
      status = std::max(status, complain(error));
    }
  }
  return status;
}

}  // namespace

void addValidateCommand(CLI::App& app, ChosenCommand& chosen) {
  struct Arguments {
    std::vector<std::string> paths;
    bool allow_outside = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("validate", "Check maps, trajectories, recordings and robots");
  command->callback([&chosen, arguments] {
    chosen = [arguments] {
      return validate(arguments->paths,
                      arguments->allow_outside ? Outside::Allowed : Outside::Refused);
    };
  });
  command
      ->add_option("path", arguments->paths,
                   "Maps, .tum files, recording folders or the .json of a robot")
      ->required()
      ->option_text("FILE|DIR ...");
  command->add_flag("--allow-outside", arguments->allow_outside, kAllowOutsideText);
}

}  // namespace handmap
