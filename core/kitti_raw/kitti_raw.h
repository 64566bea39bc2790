// A drive of KITTI's raw data (synchronized and rectified) as a recording.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace handmap {

/// Whether a folder looks like one: images or scans with their times.
bool isKittiRaw(const std::filesystem::path& folder);

struct ImportedDrive {
  std::size_t pairs = 0;
  std::size_t scans = 0;
  std::size_t poses = 0;  ///< true ones
};

/// Writes the new folder `out`. Throws BadInput with file and place, RunFailed where it cannot be
/// written.
ImportedDrive importKittiRaw(const std::filesystem::path& folder, const std::filesystem::path& out,
                             const std::string& name, std::vector<std::string>& notes,
                             const std::function<void(double)>& progress = {},
                             const std::stop_token& stop = {});

}  // namespace handmap
