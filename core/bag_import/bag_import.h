// Makes recordings of bags.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/bag_import/bag_plan.h"

namespace handmap {

struct ImportedBag {
  std::size_t pairs = 0;  ///< of images
  std::size_t scans = 0;
  std::size_t poses = 0;
};

/// In a new folder. `notes` gets what was taken for what, and left out; `progress` the share that
/// is done. Reads the bag twice, and keeps little of it. Throws BadInput, with what it holds, where
/// nothing in it sees; RunFailed as RecordingWriter does.
ImportedBag importBag(const Bag& bag, const BagPlan& plan, const std::filesystem::path& folder,
                      const std::string& name, std::vector<std::string>& notes,
                      const std::function<void(double)>& progress = {},
                      const std::stop_token& stop = {});

}  // namespace handmap
