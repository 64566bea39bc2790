// handmap-cli. Exit status: 0 done, 1 wrong usage, 2 bad input, 3 the run itself failed, 130
// interrupted.
#include <cstdio>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/messages.h"

namespace handmap {
namespace {

std::string hintFor(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "" : " " + chosen.front()->get_name();
  return "handmap-cli" + command + " --help";
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
  addOdometryCommand(app, chosen);
  addCalibrateCommand(app, chosen);
  addCompareCommand(app, chosen);
  addEvaluateCommand(app, chosen);
  addValidateCommand(app, chosen);
  addTrainCommand(app, chosen);
  addClassifyCommand(app, chosen);
  try {
    app.parse(argc, argv);
    const int status = chosen();
    if (std::fflush(stdout) == 0) return status;
    return complain(Error(ErrorCode::RunFailed, "stdout: cannot be written"));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
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
