// A rendered drive kept on disk, so that it is rendered once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>

#include "core/rendering/rendered_source.h"

namespace handmap {

struct RenderedDrive {
  World world;
  SimulationOptions simulation;
  RenderOptions rendering;
  Looking looking = Looking::Around;
  std::uint64_t seed = 1;
};

/// Sees to it that the drive's recording is in `folder`: it is there as a whole or not at all.
/// `progress` hears the share done, 0 … 1. Returns false when `stop` was requested before the end.
/// Throws RunFailed where nothing can be written, and as renderedSource().
bool renderOnce(const RenderedDrive& drive, const std::filesystem::path& folder,
                const std::stop_token& stop, const std::function<void(double)>& progress);

}  // namespace handmap
