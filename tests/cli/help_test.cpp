#include "tests/cli/program.h"

namespace handmap {
namespace {

using Help = CliTest;

TEST_F(Help, TellsTheVersion) { expectDone(run({"--version"}), "handmap-cli 0.2.0\n"); }

TEST_F(Help, OfTheProgramAndOfEveryCommand) {
  const std::filesystem::path expected = HANDMAP_CLI_EXPECTED;
  expectDone(run({"--help"}), contentOf(expected / "help.txt"));
  for (const std::string command :
       {"run", "odometry", "calibrate", "simulate", "perturb", "compare", "convert", "evaluate",
        "figures", "sketch-stats", "validate", "train", "classify", "import", "info", "report",
        "try", "trace", "sheet"}) {
    expectDone(run({command, "--help"}), contentOf(expected / ("help-" + command + ".txt")));
  }
}

TEST_F(Help, IsPointedToAfterWrongUsage) {
  expectFailed(run({}), 1,
               "handmap-cli: error: A subcommand is required\n"
               "hint: handmap-cli --help\n");
  expectFailed(run({"fly"}), 1,
               "handmap-cli: error: found fly, expected a command\n"
               "hint: handmap-cli --help\n");
  expectFailed(run({"runn"}), 1,
               "handmap-cli: error: runn: did you mean run?\n"
               "hint: handmap-cli --help\n");
  expectFailed(run({"validate", "row-truth.handmap", "--allow-outsid"}), 1,
               "handmap-cli: error: --allow-outsid: did you mean --allow-outside?\n"
               "hint: handmap-cli validate --help\n");
  expectFailed(run({"run"}), 1,
               "handmap-cli: error: --map is required\n"
               "hint: handmap-cli run --help\n");
  expectFailed(run({"validate", "row-truth.handmap", "--fast"}), 1,
               "handmap-cli: error: The following argument was not expected: --fast\n"
               "hint: handmap-cli validate --help\n");
}

}  // namespace
}  // namespace handmap
