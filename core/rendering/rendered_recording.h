// A rendered drive kept on disk, so that it is rendered once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
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

/// The drive out of its recording in `folder`. Where there is none it is rendered as it is asked
/// for, and kept there once it was asked for to its end: the recording is there as a whole or not
/// at all, and gives the same. A folder that cannot be written is no error: the drive is rendered
/// each time. At its end when `stop` was requested. Throws as renderedSource() and openRecording().
std::unique_ptr<ObservationSource> renderedOnce(const RenderedDrive& drive,
                                                const std::filesystem::path& folder,
                                                const std::stop_token& stop);

}  // namespace handmap
