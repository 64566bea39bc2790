#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/messages.h"
#include "core/map/map_io.h"
#include "core/recording/validation.h"

namespace handmap {

namespace {

namespace fs = std::filesystem;

int validateRecording(const std::string& path) {
  const Recording recording = openRecording(path);
  const std::vector<std::string> problems = problemsOf(recording);
  for (const std::string& problem : problems) complain(Error(ErrorCode::BadInput, problem));
  if (!problems.empty()) return static_cast<int>(ErrorCode::BadInput);
  fmt::print("ok: {}: recording of {} frames\n", path, recording.rows.size());
  return 0;
}

int validateFile(const std::string& path) {
  if (fs::path(path).extension() == ".tum") {
    fmt::print("ok: {}: trajectory of {} poses\n", path, readTum(path).poses().size());
  } else {
    fmt::print("ok: {}: map of {} buildings\n", path, readMap(path).buildings.size());
  }
  return 0;
}

/// Goes on after a problem, so that one call tells them all.
int validate(const std::vector<std::string>& paths) {
  int status = 0;
  for (const std::string& path : paths) {
    try {
      std::error_code error;
      const bool folder = fs::is_directory(path, error);
      status = std::max(status, folder ? validateRecording(path) : validateFile(path));
    } catch (const Error& error) {
      status = std::max(status, complain(error));
    }
  }
  return status;
}

}  // namespace

void addValidateCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto paths = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("validate", "Check maps, trajectories and recordings");
  command->callback([&chosen, paths] { chosen = [paths] { return validate(*paths); }; });
  command->add_option("path", *paths, "Maps, .tum files or recording folders")
      ->required()
      ->option_text("FILE|DIR ...");
}

}  // namespace handmap
