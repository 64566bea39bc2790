// --odometry, of the commands that replay a recording.
#pragma once

#include <memory>
#include <string>

#include <CLI/App.hpp>

#include "app/cli/progress.h"
#include "core/trajectory/odometry_choice.h"

namespace handmap {

/// A word for the kind, or a file: replay.odometry. The help tells the default, which is the kind
/// now.
void addOdometry(CLI::App& command, ReplayOptions& replay, OdometryKind& kind);

/// The source of a recording; what was taken for another than was asked for is told on stderr
/// (unless quiet), and in `taken`.
std::unique_ptr<ObservationSource> openWithOdometry(const Recording& recording,
                                                    const ReplayOptions& replay, OdometryKind kind,
                                                    Verbosity verbosity, std::string& taken);

}  // namespace handmap
