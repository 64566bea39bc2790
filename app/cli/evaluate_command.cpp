#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/share_progress.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/experiments/report.h"

namespace handmap {

namespace {

constexpr int kMostShards = 100000;
constexpr std::size_t kMostSigmas = 20;

struct EvaluateArguments {
  Experiment experiment;
  std::optional<Shard> shard;  ///< absent: all, and the report
  bool unrestricted = false;
  bool merge = false;
  int threads = 0;
  std::string out;
};

ExperimentKind kindOf(const std::string& word) {
  if (word == "table1") return ExperimentKind::Table1;
  if (word == "table2") return ExperimentKind::Table2;
  if (word == "fig8") return ExperimentKind::Figure8;
  throw CLI::ValidationError(fmt::format("found {}, expected table1, table2 or fig8", word));
}

std::vector<Method> methodsOf(const std::string& words) {
  std::vector<Method> methods;
  for (const std::string_view word : splitFields(words, ',')) {
    if (word != "handmap" && word != "paper") {
      throw CLI::ValidationError(
          "--methods", fmt::format("found {}, expected handmap, paper or handmap,paper", words));
    }
    methods.push_back(word == "paper" ? Method::Paper : Method::Handmap);
  }
  return methods;
}

std::vector<double> sigmasOf(const std::string& words) {
  std::vector<double> sigmas_m;
  for (const std::string_view word : splitFields(words, ',')) {
    const std::optional<double> value = parseFinite(word);
    if (!value || *value < 0.01 || *value > 1000.0 || sigmas_m.size() == kMostSigmas) {
      throw CLI::ValidationError(
          "--sigmas",
          fmt::format("found {}, expected up to {} numbers from 0.01 to 1000, as 1,5,12.5", words,
                      kMostSigmas));
    }
    sigmas_m.push_back(*value);
  }
  return sigmas_m;
}

Shard shardOf(const std::string& words) {
  const std::vector<std::string_view> parts = splitFields(words, '/');
  const auto part = [&](std::size_t i) {
    return i < parts.size() ? parseInteger(parts[i]).value_or(0) : 0;
  };
  if (parts.size() != 2 || part(1) > kMostShards || part(0) < 1 || part(0) > part(1)) {
    throw CLI::ValidationError(
        "--shard",
        fmt::format("found {}, expected I/N with I from 1 to N, N up to {}", words, kMostShards));
  }
  return {static_cast<int>(part(0)), static_cast<int>(part(1))};
}

void checkFolder(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error) || std::filesystem::is_directory(path, error)) return;
  throw Error(ErrorCode::Usage,
              fmt::format("{}: found something there, expected a folder or nothing", path));
}

int evaluate(EvaluateArguments arguments) {
  checkFolder(arguments.out);
  Experiment& experiment = arguments.experiment;
  if (experiment.sigmas_m.empty()) experiment.sigmas_m = usualSigmas(experiment.kind);
  if (arguments.unrestricted) experiment.settings.keeping = Keeping::Nothing;
  if (!arguments.merge) {
    const Interrupt interrupt;
    ShareProgress progress;
    const int run = runTrials(experiment, arguments.shard.value_or(Shard{}), arguments.out,
                              arguments.threads, interrupt.token(), [&](int done, int all) {
                                progress.update(fmt::format("trial {} of {}", done, all),
                                                static_cast<double>(done) / all);
                              });
    if (interrupt.requested()) {
      fmt::print(stderr, "handmap-cli: interrupted, {} trials were run and are kept\n", run);
      return Interrupt::kExitStatus;
    }
    if (arguments.shard) {
      fmt::print("{}: shard {}/{} is done, {} trials were run\n", arguments.out,
                 arguments.shard->index, arguments.shard->count, run);
      return 0;
    }
  }
  const auto trials = readTrials(arguments.out, experiment.settings);
  if (trials.empty()) throwBadInput(arguments.out, "", "no trials", "tables trials-*.csv");
  const Report report = reportOf(experiment, trials);
  writeReport(report, arguments.out);
  fmt::print("{}", report.markdown);
  return 0;
}

constexpr auto kFooter =
    "Trials are kept in DIR/trials-*.csv, one a line; those that are there are not run again, so\n"
    "that the same command resumes, adds trials, or makes another table of the same trials.\n"
    "In parallel, in processes or on machines that share DIR, and then the report:\n"
    "  sbatch --array=1-50 --wrap 'handmap-cli evaluate table2 --shard $SLURM_ARRAY_TASK_ID/50 "
    "--threads 1 --out DIR'\n"
    "  parallel handmap-cli evaluate table2 --shard {}/8 --threads 1 --out DIR ::: $(seq 8)\n"
    "  seq 8 | xargs -P 8 -I{} handmap-cli evaluate table2 --shard {}/8 --threads 1 --out DIR\n"
    "  handmap-cli evaluate table2 --merge --out DIR\n"
    "\n";

}  // namespace

void addEvaluateCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<EvaluateArguments>();
  EvaluateArguments& a = *arguments;
  TrialSettings& settings = a.experiment.settings;
  CLI::App* command = app.add_subcommand("evaluate", "Run the paper's experiments in simulation");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return evaluate(*arguments); }; });
  command->footer(kFooter + app.get_footer());
  const auto add = [&](const std::string& name, auto parse, auto& value, const std::string& text) {
    return command->add_option_function<std::string>(
        name, [parse, &value](const std::string& words) { value = parse(words); }, text);
  };
  add("experiment", kindOf, a.experiment.kind,
      "Errors of the buildings, success against the error of the drawing, errors over the way "
      "(required)")
      ->required()
      ->option_text("table1|table2|fig8");
  addNumber(*command, "--trials", a.experiment.trials, 1, 1e5, "For each sigma and method");
  add("--sigmas", sigmasOf, a.experiment.sigmas_m,
      "Errors of the drawings, metres (default 1,5,10,12.5,15 for table2, else 5)")
      ->option_text("N,N");
  add("--methods", methodsOf, a.experiment.methods, "Which to try (default handmap,paper)")
      ->option_text("handmap,paper");
  addNumber(*command, "--slam-particles", settings.slam_particles, 1, 1e5,
            "Hypotheses of pose and map");
  addNumber(*command, "--pso-particles", settings.pso_particles, 1, 1e4, "Swarm of a building");
  command->add_flag("--unrestricted", a.unrestricted,
                    "Drawings need not keep side and order of the buildings");
  addSeed(*command, settings.seed, "Trial I has the scene and noise of seed N + I");
  addNumber(*command, "--threads", a.threads, 0, 1024,
            "Trials at a time; 0 for all; the result is the same");
  CLI::Option* shard =
      add("--shard", shardOf, a.shard, "Run each Nth trial from the Ith, no report");
  shard->option_text("I/N");
  command->add_flag("--merge", a.merge, "Run none, report on what is there")->excludes(shard);
  command->add_option("--out", a.out, "Trials, report.md, report.csv and charts (required)")
      ->required()
      ->option_text("DIR");
}

}  // namespace handmap
