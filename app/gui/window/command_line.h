// The options of the desktop program.
#pragma once

#include <QStringList>
#include <optional>

#include "core/recording/recording.h"
#include "drivers/virtual/virtual_rig_kind.h"

namespace handmap {

struct CommandLine {
  QString map;        ///< empty: none
  QString recording;  ///< empty: none
  QString rig;        ///< of a live robot; empty: none
  std::optional<VirtualRigKind> virtual_rig;
  std::optional<ReplayOptions> replay;  ///< nullopt: as the last time
  std::optional<double> speed;          ///< times the clock of the recording; 0: as fast as can be
  std::optional<int> seed;
  bool demo = false;
  bool run = false;
  bool exit_after_run = false;
  bool verbose = false;
  QString guide_folder;   ///< empty: no pictures of the guide
  QString report_folder;  ///< empty: no report; otherwise the run goes as fast as possible

  /// The program ends with the run and speaks through its exit status.
  bool isBatch() const {
    return exit_after_run || !report_folder.isEmpty() || !guide_folder.isEmpty();
  }
};

/// Handles --help and --version. Throws Error (Usage) for what cannot be.
CommandLine parseCommandLine(const QStringList& arguments);

}  // namespace handmap
