// --odometry, of the commands that replay a recording.
#pragma once

#include <memory>
#include <string>

#include <CLI/App.hpp>

#include "core/trajectory/odometry_choice.h"

namespace handmap {

/// A word for the kind, or a file: replay.odometry. The help tells the default, which is the kind
/// now.
void addOdometry(CLI::App& command, ReplayOptions& replay, OdometryKind& kind);

/// Opens the recording; what auto took is told on stderr, and in `taken`.
std::unique_ptr<ObservationSource> openWithOdometry(const std::string& folder,
                                                    const ReplayOptions& replay, OdometryKind kind,
                                                    std::string& taken);

}  // namespace handmap
