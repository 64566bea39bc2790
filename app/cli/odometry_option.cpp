#include "app/cli/odometry_option.h"

#include <utility>

#include <fmt/format.h>

namespace handmap {

void addOdometry(CLI::App& command, ReplayOptions& replay, OdometryKind& kind) {
  const auto choose = [&](const std::string& word) {
    for (const OdometryKind known :
         {OdometryKind::Recorded, OdometryKind::Visual, OdometryKind::Scan, OdometryKind::Auto}) {
      if (word != nameOf(known)) continue;
      kind = known;
      return;
    }
    kind = OdometryKind::Recorded;
    replay.odometry = word;
  };
  command
      .add_option_function<std::string>(
          "--odometry", choose,
          fmt::format("What tells the motion: a file, the recording's own, the images, the scans "
                      "matched with each other, or what makes the scans the sharpest (default {})",
                      nameOf(kind)))
      ->option_text("FILE.tum|recorded|visual|scan|auto");
}

std::unique_ptr<ObservationSource> openWithOdometry(const Recording& recording,
                                                    const ReplayOptions& replay, OdometryKind kind,
                                                    Verbosity verbosity, std::string& taken) {
  ChosenOdometry choice = replayWithOdometry(recording, replay, kind);
  taken = nameOf(choice.kind);
  if (verbosity == Verbosity::Quiet) return std::move(choice.source);
  if (kind == OdometryKind::Recorded && choice.kind == OdometryKind::Scan) {
    fmt::print(stderr, "odometry: none is recorded, the scans tell the motion\n");
  }
  if (kind == OdometryKind::Auto) {
    fmt::print(stderr, "odometry: {} taken: {}\n", taken, choice.reason);
  }
  return std::move(choice.source);
}

}  // namespace handmap
