#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/odometry_option.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace handmap {

namespace {

struct OdometryArguments {
  std::string recording;
  ReplayOptions replay;
  OdometryKind kind = OdometryKind::Visual;
  bool quiet = false;
  std::string out;
};

struct Drive {
  std::vector<StampedPose> poses;
  double length_m = 0.0;
  int guessed = 0;
  int skipped = 0;
};

void add(Drive& drive, const Observation& observation) {
  if (!drive.poses.empty()) {
    drive.length_m += (observation.odometry.position() - drive.poses.back().pose.position()).norm();
  }
  drive.poses.push_back({observation.time_s, observation.odometry});
  drive.guessed += observation.odometry_guessed;
}

/// nullopt when it was interrupted.
std::optional<Drive> driveToEnd(ObservationSource& source, Verbosity verbosity) {
  const Interrupt interrupt;
  Progress progress(source.info().observations, verbosity);
  Drive drive;
  std::string first_reason;
  const auto done = [&] { return static_cast<int>(drive.poses.size()) + drive.skipped; };
  while (!interrupt.requested()) {
    try {
      const auto observation = source.next();
      if (!observation) break;
      add(drive, *observation);
      if (observation->odometry_guessed) {
        progress.repeatable(fmt::format("frame {}: motion guessed", observation->frame));
      }
    } catch (const FrameError& error) {
      ++drive.skipped;
      if (first_reason.empty()) first_reason = error.what();
      progress.repeatable(fmt::format("frame {} skipped: {}", error.frame(), error.what()));
    }
    progress.update(done(), 0.0);
  }
  progress.finish(done());
  if (interrupt.requested()) {
    progress.message("interrupted, nothing written");
    return std::nullopt;
  }
  if (drive.poses.empty()) {
    throw Error(ErrorCode::RunFailed, fmt::format("none of {} observations could be used; the "
                                                  "first: {}",
                                                  drive.skipped, first_reason));
  }
  return drive;
}

int odometry(OdometryArguments arguments) {
  checkOutputFiles({arguments.out}, {arguments.replay.odometry}, NewOdometry::Allowed);
  if (arguments.kind == OdometryKind::Visual) arguments.replay.kind = SourceKind::Images;
  if (arguments.kind == OdometryKind::Scan) arguments.replay.kind = SourceKind::Points;
  std::string taken;
  const Verbosity verbosity = arguments.quiet ? Verbosity::Quiet : Verbosity::Usual;
  const auto source = openWithOdometry(openRecording(arguments.recording), arguments.replay,
                                       arguments.kind, verbosity, taken);
  const std::optional<Drive> drive = driveToEnd(*source, verbosity);
  if (!drive) return Interrupt::kExitStatus;
  writeFileAtomically(arguments.out, formatTum(drive->poses));
  fmt::print("{}: {} poses over {:.2f} m, {} guessed, {} frames skipped\n", arguments.out,
             drive->poses.size(), drive->length_m, drive->guessed, drive->skipped);
  return 0;
}

}  // namespace

void addOdometryCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<OdometryArguments>();
  OdometryArguments& a = *arguments;
  CLI::App* command = app.add_subcommand("odometry", "Tell the robot's motion from what it sees");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return odometry(*arguments); }; });
  command->add_option("--recording", a.recording, "What the robot saw (required)")
      ->required()
      ->option_text("DIR");
  addFrames(*command, a.replay, "Take each Nth observation of the source");
  addOdometry(*command, a.replay, a.kind);
  addQuiet(*command, a.quiet);
  command->add_option("--out", a.out, "Poses from the first observation on (required)")
      ->required()
      ->option_text("odometry.tum");
}

}  // namespace handmap
