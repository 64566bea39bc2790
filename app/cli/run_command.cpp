#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/live_run.h"
#include "app/cli/messages.h"
#include "app/cli/odometry_option.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "app/cli/run_folder.h"
#include "app/cli/run_summary.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/classification/load_classifier.h"
#include "core/map/map_io.h"
#include "core/map/references.h"
#include "core/plausibility/drawing.h"
#include "core/plausibility/plausibility.h"
#include "core/recording/image_file.h"
#include "core/run_log/run_film.h"
#include "core/run_log/run_log.h"
#include "core/run_log/run_part.h"
#include "core/session/lost_and_found.h"
#include "core/session/redone_acts.h"
#include "core/session/run_session.h"
#include "drivers/pace/punctual_source.h"

namespace handmap {

namespace {

struct RunArguments {
  std::string map;
  std::string recording;
  LiveArguments live;
  ReplayOptions replay;
  OdometryKind odometry = OdometryKind::Recorded;
  RunSettings settings;
  std::vector<std::string> free;
  bool localize_only = false;
  double speed = 0.0;
  std::string out;
  std::string trajectory;
  std::string report;
  std::string local_map;
  std::string mcap;
  std::string film;
  std::string keep;
  std::string model;
  std::optional<int> building_class;
  std::string given_poses;
  bool allow_outside = false;
  bool quiet = false;
  bool json = false;

  Verbosity verbosity() const { return quiet ? Verbosity::Quiet : Verbosity::Usual; }
};

void checkOutputs(const RunArguments& arguments, const std::string& model) {
  checkOutputFiles(
      {arguments.out, arguments.trajectory, arguments.report, arguments.local_map, arguments.mcap,
       RunFilm::isVideo(arguments.film) ? arguments.film : std::string()},
      {arguments.map, arguments.replay.odometry, model, arguments.given_poses, arguments.live.rig});
}

void check(const CLI::App& command, const RunArguments& arguments) {
  checkLive(command, arguments.live, !arguments.recording.empty());
  if (arguments.replay.to && *arguments.replay.to < arguments.replay.from) {
    throw Error(ErrorCode::Usage, fmt::format("--to: found {}, expected {} (--from) or more",
                                              *arguments.replay.to, arguments.replay.from));
  }
  const bool fixed = arguments.localize_only || arguments.settings.method == Method::Paper;
  if (!arguments.free.empty() && fixed) {
    throw Error(ErrorCode::Usage, "--free: not with --method paper or --localize-only");
  }
  if (!arguments.given_poses.empty() && arguments.live.any()) {
    throw Error(ErrorCode::Usage, "--given-poses: not with a live robot; run its recording");
  }
  checkOutputs(arguments, arguments.model);
}

Map readDrawing(const std::string& path) {
  Map drawing = readMap(path);
  if (drawing.buildings.empty()) throwBadInput(path, "buildings", "none", "at least one");
  if (!drawing.start) throwBadInput(path, "start", "none", "where the robot starts");
  return drawing;
}

/// Forward is to the right; what is surely a wall is black.
cv::Mat picture(const LocalMap& map) {
  cv::Mat shades;
  map.cells().convertTo(shades, CV_8U, -255.0, 255.0);
  cv::flip(shades, shades, 0);
  return shades;
}

int doneOf(const RunSession& session) {
  return static_cast<int>(session.frames().size() + session.skipped().size());
}

/// What it found last; nullptr when it was stopped. `follow` is told each step, and may put another
/// session over the same observations in place of this one.
std::shared_ptr<const Snapshot> runToEnd(
    std::unique_ptr<RunSession>& running, const std::stop_token& stop, Progress& progress,
    const std::function<void(std::shared_ptr<const Snapshot>&)>& follow = {}) {
  std::shared_ptr<const Snapshot> last;
  std::size_t skipped = 0;
  const auto done = [&] { return doneOf(*running); };
  for (bool more = true; more;) {
    RunSession& session = *running;
    const int before = done();
    auto snapshot = session.step(stop, [&](double share) { progress.update(before, share); });
    more = snapshot != nullptr;
    if (more) last = std::move(snapshot);
    if (more && session.frames().back().odometry_guessed && done() > before) {
      progress.repeatable(fmt::format("frame {}: motion guessed", session.frames().back().frame));
    }
    for (; skipped < session.skipped().size(); ++skipped) {
      const SkippedFrame& frame = session.skipped()[skipped];
      progress.repeatable(fmt::format("frame {} skipped: {}", frame.frame, frame.reason));
    }
    if (more && follow) follow(last);
  }
  progress.finish(done());
  if (!stop.stop_requested()) {
    for (const RunWarning& warning : running->warnings()) {
      progress.message(fmt::format("warning: {} {}", warning.message, warning.hint));
    }
    return last;
  }
  progress.message("interrupted, nothing written");
  return nullptr;
}

/// All outputs are in one folder then.
void keepAll(RunArguments& arguments) {
  const RunFolder kept{arguments.keep};
  arguments.out = kept.refined();
  arguments.trajectory = kept.trajectory();
  arguments.report = kept.report();
  arguments.mcap = kept.mcap();
}

/// A folder that is made here, and goes again where nothing was written to it.
class NewFolder {
 public:
  explicit NewFolder(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::create_directories(path, error)) made_ = path;
    if (error) {
      throw Error(ErrorCode::RunFailed,
                  fmt::format("{}: cannot be created: {}", path.string(), error.message()));
    }
  }
  ~NewFolder() {
    std::error_code not_empty;
    if (!made_.empty()) std::filesystem::remove(made_, not_empty);
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  std::filesystem::path made_;
};

void writeOutputs(const RunArguments& arguments, const RunSession& session, const Snapshot& last) {
  if (!arguments.out.empty()) {
    Map refined = session.refinedMap();
    moveReferences(refined, arguments.map, arguments.out);
    writeMap(refined, arguments.out);
  }
  if (!arguments.trajectory.empty()) {
    writeFileAtomically(arguments.trajectory, formatTum(session.trajectory()));
  }
  if (!arguments.report.empty()) writeFileAtomically(arguments.report, session.reportJson());
  if (!arguments.local_map.empty()) writePng(picture(last.local_map), arguments.local_map);
}

/// The file of the model that was asked for, else of that of the map; empty: the program's own.
std::filesystem::path modelFile(const RunArguments& arguments, const Map& drawing) {
  if (!arguments.model.empty()) return arguments.model;
  const auto reference = modelReference(drawing, arguments.map);
  if (!reference) return {};
  checkReference(*reference, arguments.map,
                 arguments.allow_outside ? Outside::Allowed : Outside::Refused);
  return targetOf(*reference, arguments.map);
}

/// nullptr: the program's own.
std::shared_ptr<const WindowClassifier> classifierFor(const RunArguments& arguments,
                                                      const Map& drawing) {
  const std::filesystem::path model = modelFile(arguments, drawing);
  checkOutputs(arguments, model);
  if (model.empty()) {
    if (!arguments.building_class) return nullptr;
    throw Error(ErrorCode::Usage, "--building-class: only with --model NAME.onnx");
  }
  try {
    return loadClassifier(model, arguments.building_class);
  } catch (const Error& error) {
    if (!arguments.model.empty()) throw;
    throw Error(error.code(), error.what(),
                "the map names this model as its own; --model takes another, or none");
  }
}

/// What is written as the run goes on, where it was asked for.
class Chronicle {
 public:
  Chronicle(const RunArguments& arguments, const Map& drawing, const SourceInfo& source) {
    if (!arguments.mcap.empty()) {
      if (const auto kept = keepUnfinished(arguments.mcap); kept && !arguments.quiet) {
        fmt::print(stderr,
                   "a run before was ended before its MCAP was whole: what there is of it is {}\n",
                   kept->string());
      }
      log_.emplace(arguments.mcap, drawing, source);
    }
    if (!arguments.film.empty()) film_.emplace(arguments.film, drawing);
  }
  void add(const Snapshot& snapshot) {
    if (log_) log_->add(snapshot);
    if (film_) film_->add(snapshot);
  }
  void finish(const RunSession& session) {
    if (log_) log_->finish(session.refinedMap(), session.trajectory(), session.warnings());
    if (film_) film_->finish();
  }

 private:
  std::optional<RunLog> log_;
  std::optional<RunFilm> film_;
};

void keepDrawing(const RunArguments& arguments, Map drawing) {
  const std::string path = RunFolder{arguments.keep}.drawing();
  moveReferences(drawing, arguments.map, path);
  writeMap(drawing, path);
}

/// What is still to be done, once the session is at its end.
int finish(const RunArguments& arguments, const Map& drawing, const RunSession& session,
           const std::shared_ptr<const Snapshot>& last, Chronicle& chronicle) {
  if (!last) return Interrupt::kExitStatus;
  writeOutputs(arguments, session, *last);
  if (!arguments.keep.empty()) keepDrawing(arguments, drawing);
  chronicle.finish(session);
  fmt::print("{}",
             arguments.json ? runSummaryJson(drawing, session) : runSummary(drawing, session));
  return 0;
}

/// Throws nothing of what may be right: it is told. The status of what cannot be.
int lookAtNumbers(const RunArguments& arguments, Recording recording, const Map& drawing) {
  if (!arguments.replay.odometry.empty()) {
    recording.odometry = readTum(arguments.replay.odometry);
  } else if (arguments.odometry != OdometryKind::Recorded) {
    recording.odometry = {};
  }
  Doubts doubts = doubtsOfDrawing(drawing, arguments.map);
  std::ranges::move(doubtsOf(recording), std::back_inserter(doubts));
  std::ranges::move(doubtsOfWay(recording, drawing, arguments.map), std::back_inserter(doubts));
  if (arguments.quiet) std::erase_if(doubts, [](const Doubt& doubt) { return !doubt.certain; });
  return complain(doubts);
}

int runRecording(RunArguments arguments, const Map& drawing) {
  const Recording recording = openRecording(arguments.recording);
  if (const int status = lookAtNumbers(arguments, recording, drawing); status != 0) return status;
  auto source = openWithOdometry(recording, arguments.replay, arguments.odometry,
                                 arguments.verbosity(), arguments.settings.odometry);
  const Interrupt interrupt;
  if (arguments.speed > 0.0) {
    source =
        std::make_unique<PunctualSource>(std::move(source), arguments.speed, interrupt.token());
  }
  Chronicle chronicle(arguments, drawing, source->info());
  auto session = std::make_unique<RunSession>(drawing, std::move(source), arguments.settings);
  Progress progress(session->source().observations, arguments.verbosity());
  const auto last =
      runToEnd(session, interrupt.token(), progress,
               [&](const std::shared_ptr<const Snapshot>& snapshot) { chronicle.add(*snapshot); });
  return finish(arguments, drawing, *session, last, chronicle);
}

/// As "Robot is here" does it in the window: the run is done again through the pose, as far as it
/// has come. What was perceived is kept for that where somebody may give one.
class GivenOnTheWay {
 public:
  GivenOnTheWay(const Map& drawing, std::shared_ptr<Tape> tape, const RunSettings& settings)
      : drawing_(drawing), tape_(std::move(tape)), settings_(settings) {}

  std::shared_ptr<const Snapshot> operator()(const StampedPose& pose,
                                             std::unique_ptr<RunSession>& running,
                                             Progress& progress) {
    if (tape_->begin() > 0) {
      progress.message("a pose was given: the beginning of the run is no longer kept");
      return nullptr;
    }
    give(settings_.given_poses, pose);
    auto again = std::make_unique<RunSession>(drawing_, tape_, settings_);
    std::shared_ptr<const Snapshot> last;
    for (const int done = doneOf(*running); doneOf(*again) < done;) {
      auto next = again->step();
      if (!next) return nullptr;
      last = std::move(next);
    }
    running = std::move(again);
    progress.message(fmt::format("a pose was given: done again through {:.1f}, {:.1f}", pose.pose.x,
                                 pose.pose.y));
    return last;
  }

 private:
  Map drawing_;
  std::shared_ptr<Tape> tape_;
  RunSettings settings_;
};

/// Ctrl-C ends the drive, not the run: what was found is smoothed and written. A second one ends
/// the program.
int runLive(const RunArguments& arguments, const Map& drawing) {
  const Interrupt interrupt;
  Progress progress(0, arguments.verbosity());
  LiveDrive drive(arguments.live, drawing, arguments.settings.seed);
  auto source = drive.open(interrupt, progress);
  if (!source) {
    progress.message("the drive was ended before the first observation, nothing written");
    return interrupt.requested() ? Interrupt::kExitStatus : static_cast<int>(ErrorCode::RunFailed);
  }
  const auto tape =
      std::make_shared<Tape>(std::move(source), arguments.settings.perception,
                             drive.mayBeGivenPoses() ? TapeLimits::toDoAgain() : TapeLimits());
  GivenOnTheWay through(drawing, tape, arguments.settings);
  auto session = std::make_unique<RunSession>(drawing, tape, arguments.settings);
  Chronicle chronicle(arguments, drawing, session->source());
  LostAndFound lost;
  const auto last = runToEnd(session, {}, progress, [&](std::shared_ptr<const Snapshot>& snapshot) {
    if (const auto given = drive.takeGivenPose()) {
      if (auto redone = through(*given, session, progress)) snapshot = std::move(redone);
    }
    chronicle.add(*snapshot);
    drive.tell(snapshot);
    const auto news = lost.hear(snapshot->report);
    if (news == LostAndFound::News::Lost) {
      progress.message("it is no longer known where the robot is");
    } else if (news == LostAndFound::News::Found) {
      progress.message("it is known again where the robot is");
    }
  });
  if (!arguments.quiet) fmt::print(stderr, "{}", drive.summary());
  return finish(arguments, drawing, *session, last, chronicle);
}

int run(const CLI::App& command, RunArguments arguments) {
  std::optional<NewFolder> kept;
  if (!arguments.keep.empty()) {
    keepAll(arguments);
    kept.emplace(arguments.keep);
  }
  check(command, arguments);
  for (const std::string& what : arguments.free) {
    (what == "scale" ? arguments.settings.free_scale : arguments.settings.free_turn) = true;
  }
  arguments.settings.slam.refine = !arguments.localize_only;
  arguments.settings.conclude_on_the_way = arguments.live.any() || arguments.speed > 0.0;
  arguments.settings.perception.classify = arguments.model != "none";
  Map drawing = readDrawing(arguments.map);
  if (!arguments.given_poses.empty()) {
    arguments.settings.given_poses = readTum(arguments.given_poses).poses();
  }
  if (arguments.settings.perception.classify) {
    arguments.settings.perception.classifier = classifierFor(arguments, drawing);
  }
  return arguments.live.any() ? runLive(arguments, drawing)
                              : runRecording(std::move(arguments), drawing);
}

}  // namespace

void addRunCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<RunArguments>();
  RunArguments& a = *arguments;
  SlamOptions& slam = a.settings.slam;
  CLI::App* command =
      app.add_subcommand("run", "Localize a recording or a live robot on a drawing and correct it");
  command->callback([&chosen, arguments, command] {
    chosen = [arguments, command] { return run(*command, *arguments); };
  });

  command->add_option("--map", a.map, "The drawing (required)")
      ->required()
      ->option_text("M.handmap");
  command->add_option("--recording", a.recording, "What the robot met")->option_text("DIR");
  addLive(*command, a.live);
  addFrames(*command, a.replay, "Take each Nth observation of the source");
  addChoice(
      *command, "--source", a.replay.kind,
      {{"auto", SourceKind::Auto}, {"images", SourceKind::Images}, {"points", SourceKind::Points}},
      "What to see with; auto takes images where there are any");
  addOdometry(*command, a.replay, a.odometry);
  command
      ->add_option(
          "--model", a.model,
          "Tells buildings in images, made by train; none: all walls are (default: that of the "
          "map, else the program's)")
      ->option_text("MODEL|NET.onnx|none");
  addBuildingClass(*command, a.building_class);
  command->add_flag("--allow-outside", a.allow_outside, kAllowOutsideText);
  addChoice(*command, "--method", a.settings.method,
            {{"handmap", Method::Handmap}, {"paper", Method::Paper}},
            "Ours (handmap) or the published FastSLAM/PSOM (paper)");
  command
      ->add_option("--free", a.free,
                   "May be off of the drawing as a whole: scale (0.7 to 1.4), turn (±40°)")
      ->delimiter(',')
      ->check(CLI::IsMember({"scale", "turn"}))
      ->option_text("scale,turn");
  addNumber(*command, "--slam-particles", slam.slam_particles, 1, 1e5,
            "Hypotheses of pose and map");
  addNumber(*command, "--pso-particles", slam.pso_particles, 1, 1e4, "Swarm of a building");
  addNumber(*command, "--pso-iterations", slam.pso_iterations, 0, 1e4, "At most, a frame");
  addChoice(*command, "--effective-ratio", slam.effective_ratio,
            {{"to-all", EffectiveRatio::ToAll}, {"to-zero", EffectiveRatio::ToZero}},
            "Hit cells of a wall against all, or against those not hit");
  command
      ->add_option("--given-poses", a.given_poses,
                   "Where the robot was at some times, in the frame of the map, as you know it")
      ->option_text("FILE.tum");
  command->add_flag("--localize-only", a.localize_only, "Leave the buildings as they are drawn");
  addNumber(*command, "--speed", a.speed, 0.0, 1e3,
            "Keep to the recording's clock times N and pass over what comes too late; 0: wait");
  addSeed(*command, a.settings.seed, "Of the random numbers");
  addQuiet(*command, a.quiet);
  command->add_flag("--json", a.json, "Print the result for programs");
  addNumber(*command, "--threads", a.settings.threads, 0, 1024,
            "0 for all; the result is the same");
  command->add_option("--out", a.out, "The corrected map")->option_text("refined.handmap");
  command->add_option("--trajectory", a.trajectory, "Where the robot was")->option_text("out.tum");
  command->add_option("--report", a.report, "Times and figures a frame")
      ->option_text("report.json");
  command
      ->add_option("--mcap", a.mcap,
                   "The whole run as messages of ROS 2, for Foxglove, Lichtblick, Rerun, RViz 2")
      ->option_text("run.mcap");
  command
      ->add_option("--film", a.film,
                   "The map as the run goes on: a video (.mp4, .avi, .mkv, .webm), or a new folder "
                   "of numbered pictures")
      ->option_text("FILM");
  command
      ->add_option("--keep", a.keep,
                   "All of it in one folder, with the drawing; report makes a page of that")
      ->excludes("--out")
      ->excludes("--trajectory")
      ->excludes("--report")
      ->excludes("--mcap")
      ->option_text("DIR");
  command->add_option("--local-map", a.local_map, "Walls around the robot at the end, black")
      ->option_text("map.png");
}

}  // namespace handmap
