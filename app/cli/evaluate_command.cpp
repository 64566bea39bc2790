#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/evaluate_runs.h"
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

enum class Wanted { Times, Trials, Reliability };

struct EvaluateArguments {
  Wanted wanted = Wanted::Trials;
  Experiment experiment;
  int trials = 0;  ///< 0: as usual
  std::vector<std::string> recordings;
  std::vector<std::string> maps;
  std::vector<std::string> truths;
  std::vector<int> from;
  SourceKind source = SourceKind::Auto;
  std::optional<Shard> shard;  ///< absent: all, and the report
  bool unrestricted = false;
  bool merge = false;
  int threads = 0;
  std::string out;
};

void choose(const std::string& word, EvaluateArguments& arguments) {
  if (word == "table1") {
    arguments.wanted = Wanted::Times;
  } else if (word == "reliability") {
    arguments.wanted = Wanted::Reliability;
    arguments.experiment.kind = ExperimentKind::Way;
  } else if (word == "table2") {
    arguments.experiment.kind = ExperimentKind::Table2;
  } else if (word == "fig8") {
    arguments.experiment.kind = ExperimentKind::Figure8;
  } else if (word == "way") {
    arguments.experiment.kind = ExperimentKind::Way;
  } else {
    throw CLI::ValidationError(
        fmt::format("found {}, expected table1, table2, fig8, way or reliability", word));
  }
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

void checkUse(const EvaluateArguments& a) {
  const auto refuse = [](const std::string& what) { throw Error(ErrorCode::Usage, what); };
  if (a.wanted != Wanted::Trials && (a.merge || a.shard)) {
    refuse("--shard and --merge: only with table2, fig8 and way");
  }
  if (a.wanted != Wanted::Reliability && !a.recordings.empty()) {
    refuse("--recording: only with reliability");
  }
  if (a.maps.size() != a.recordings.size() || a.truths.size() != a.recordings.size()) {
    refuse(fmt::format("found {} --recording, {} --map and {} --truth, expected as many of each",
                       a.recordings.size(), a.maps.size(), a.truths.size()));
  }
  if (!a.from.empty() && a.from.size() != a.recordings.size()) {
    refuse(fmt::format("found {} --recording and {} --from, expected one each, or no --from",
                       a.recordings.size(), a.from.size()));
  }
}

int print(const Report& report, const std::string& folder) {
  writeReport(report, folder);
  fmt::print("{}", report.markdown);
  return 0;
}

int evaluateTrials(EvaluateArguments arguments) {
  Experiment& experiment = arguments.experiment;
  if (arguments.trials > 0) experiment.trials = arguments.trials;
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
  return print(reportOf(experiment, trials), arguments.out);
}

int evaluate(EvaluateArguments a) {
  checkUse(a);
  checkFolder(a.out);
  if (a.experiment.sigmas_m.empty()) a.experiment.sigmas_m = usualSigmas(a.experiment.kind);
  if (a.unrestricted) a.experiment.settings.keeping = Keeping::Nothing;
  if (a.wanted == Wanted::Trials) return evaluateTrials(a);
  std::optional<Report> report;
  if (a.wanted == Wanted::Times) {
    report = evaluateTimes(a.experiment.settings.seed, a.trials, a.threads);
  } else {
    std::vector<RealRun> real;
    for (std::size_t i = 0; i < a.recordings.size(); ++i) {
      ReplayOptions replay;
      replay.kind = a.source;
      if (!a.from.empty()) replay.from = a.from[i];
      real.push_back({a.recordings[i], a.maps[i], a.truths[i], replay});
    }
    report = evaluateReliability(a.experiment, a.trials, real);
  }
  if (!report) {
    fmt::print(stderr, "handmap-cli: interrupted, nothing written\n");
    return Interrupt::kExitStatus;
  }
  return print(*report, a.out);
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
  command
      ->add_option_function<std::string>(
          "experiment", [&a](const std::string& word) { choose(word, a); },
          "Processing time of a frame (table1), success (table2) and errors of the buildings "
          "(fig8) "
          "against the error of the drawing, errors over the way (way), stated against true "
          "probability (reliability) (required)")
      ->required()
      ->option_text("table1|table2|fig8|way|reliability");
  addNumber(*command, "--trials", a.trials, 0, 1e5,
            "For each sigma and method; drives of table1, of each sigma of reliability; 0: 100, of "
            "table1 3, of reliability 10");
  add("--sigmas", sigmasOf, a.experiment.sigmas_m,
      "Errors of the drawings, metres (default 1,5,10,12.5,15 for table2 and fig8, else 5)")
      ->option_text("N,N");
  add("--methods", methodsOf, a.experiment.methods, "Which to try (default handmap,paper)")
      ->option_text("handmap,paper");
  addNumber(*command, "--slam-particles", settings.slam_particles, 1, 1e5,
            "Hypotheses of pose and map");
  addNumber(*command, "--pso-particles", settings.pso_particles, 1, 1e4, "Swarm of a building");
  command->add_flag("--unrestricted", a.unrestricted,
                    "Drawings need not keep side and order of the buildings");
  addChoice(*command, "--like", settings.like, {{"sigma", Like::Sigma}, {"people", Like::People}},
            "Errors of the drawings: each by itself; or as people draw, their places off by sigma");
  addSeed(*command, settings.seed, "Trial I has the scene and noise of seed N + I");
  addNumber(*command, "--threads", a.threads, 0, 1024,
            "Trials at a time; 0 for all; the result is the same");
  CLI::Option* shard =
      add("--shard", shardOf, a.shard, "Run each Nth trial from the Ith, no report");
  shard->option_text("I/N");
  command->add_flag("--merge", a.merge, "Run none, report on what is there")->excludes(shard);
  const auto repeated = [&](const char* name, auto& values, const std::string& text,
                            const std::string& kind) -> CLI::Option* {
    return command->add_option(name, values, text)
        ->option_text(kind)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  };
  repeated("--recording", a.recordings, "reliability: a real run too, with truth.tum; repeatable",
           "DIR");
  repeated("--map", a.maps, "Its drawing, one each", "M.handmap");
  repeated("--truth", a.truths, "Its true map, one each", "T.handmap");
  repeated("--from", a.from, "Its first frame, one each or none", "N")
      ->check(CLI::Range(0, 2147483647));
  addChoice(
      *command, "--source", a.source,
      {{"auto", SourceKind::Auto}, {"images", SourceKind::Images}, {"points", SourceKind::Points}},
      "Of real runs: what to see with");
  command->add_option("--out", a.out, "Trials, report.md, report.csv and charts (required)")
      ->required()
      ->option_text("DIR");
}

}  // namespace handmap
