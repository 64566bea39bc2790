// All of a run in one folder: what run --keep writes and report reads.
#pragma once

#include <filesystem>
#include <string>

namespace handmap {

struct RunFolder {
  std::filesystem::path folder;

  std::string drawing() const { return folder / "drawing.handmap"; }
  std::string refined() const { return folder / "refined.handmap"; }
  std::string trajectory() const { return folder / "trajectory.tum"; }
  std::string report() const { return folder / "report.json"; }
  std::string mcap() const { return folder / "run.mcap"; }
};

}  // namespace handmap
