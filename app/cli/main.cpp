// handmap-cli. Exit status: 0 done, 1 wrong usage, 2 bad input, 3 the run itself failed, 130
// interrupted.
#include <algorithm>
#include <cstdio>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/messages.h"
#include "core/base/spelling.h"

namespace handmap {
namespace {

std::string hintFor(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "" : " " + chosen.front()->get_name();
  return "handmap-cli" + command + " --help";
}

/// The names of what may stand there.
std::vector<std::string> wordsOf(const CLI::App& app, bool options) {
  std::vector<std::string> words;
  if (options) {
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    }
  } else {
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
      words.push_back(command->get_name());
    }
  }
  return words;
}

std::optional<std::string> correction(const std::string& word, const CLI::App& app) {
  const std::vector<std::string> words = wordsOf(app, word.starts_with("--"));
  const std::vector<std::string_view> known(words.begin(), words.end());
  if (std::ranges::find(words, word) != words.end()) return std::nullopt;
  const auto meant = likelyMeant(word, known);
  return meant ? std::optional(fmt::format("{}: did you mean {}?", word, *meant)) : std::nullopt;
}

/// A misspelt or unknown command, a misspelt option; nullopt where something else is wrong.
std::optional<std::string> slipIn(const CLI::App& app, int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) return std::nullopt;
  const auto commands = app.get_subcommands(nullptr);
  const auto chosen = std::ranges::find(commands, words[0], &CLI::App::get_name);
  if (chosen == commands.end()) {
    if (auto slip = correction(words[0], app)) return slip;
    if (words[0].starts_with("-")) return std::nullopt;
    return fmt::format("found {}, expected a command", words[0]);
  }
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) continue;
    if (auto slip = correction(words[i].substr(0, words[i].find('=')), **chosen)) return slip;
  }
  return std::nullopt;
}

int runProgram(int argc, char** argv) {
  CLI::App app("Handmap finds a robot on a map drawn from memory and corrects the drawing.",
               "handmap-cli");
  app.set_version_flag("--version", "handmap-cli " HANDMAP_VERSION, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 done, 1 wrong usage, 2 bad input, 3 the run itself failed, "
      "130 interrupted.");
  app.failure_message([](const CLI::App*, const CLI::Error&) { return std::string(); });
  ChosenCommand chosen;
  addRunCommand(app, chosen);
  addSimulateCommand(app, chosen);
  addPerturbCommand(app, chosen);
  addTraceCommand(app, chosen);
  addSheetCommand(app, chosen);
  addInfoCommand(app, chosen);
  addImportCommand(app, chosen);
  addOdometryCommand(app, chosen);
  addCalibrateCommand(app, chosen);
  addCompareCommand(app, chosen);
  addReportCommand(app, chosen);
  addFiguresCommand(app, chosen);
  addSketchStatsCommand(app, chosen);
  addConvertCommand(app, chosen);
  addEvaluateCommand(app, chosen);
  addValidateCommand(app, chosen);
  addTryCommand(app, chosen);
  addTrainCommand(app, chosen);
  addClassifyCommand(app, chosen);
  try {
    app.parse(argc, argv);
    const int status = chosen();
    if (std::fflush(stdout) == 0) return status;
    return complain(Error(ErrorCode::RunFailed, "stdout: cannot be written"));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    if (const auto slip = slipIn(app, argc, argv)) {
      return complain(Error(ErrorCode::Usage, *slip, hintFor(app)));
    }
    return complain(Error(ErrorCode::Usage, error.what(), hintFor(app)));
  } catch (const Error& error) {
    return complain(error);
  } catch (const std::exception& error) {
    return complain(Error(ErrorCode::RunFailed, error.what()));
  }
}

}  // namespace
}  // namespace handmap

int main(int argc, char** argv) { return handmap::runProgram(argc, argv); }
