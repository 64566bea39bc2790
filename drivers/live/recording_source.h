// A source that is recorded as it runs: what the run gets is to the bit what a replay of the
// recording gives.
#pragma once

#include <functional>
#include <memory>

#include "core/recording/recording.h"
#include "core/rig/rig_monitor.h"

namespace handmap {

/// Told after every observation, and when the recording had to end.
using RecordingListener = std::function<void(const RecordingStatus&)>;

/// Writes each observation before it is given out. When it can no longer be written (a disk that is
/// full or gone) the recording ends with what is there, and the run goes on. Throws RunFailed where
/// the folder is not new, or cannot be made.
std::unique_ptr<ObservationSource> recorded(std::unique_ptr<ObservationSource> source,
                                            const std::filesystem::path& folder,
                                            RecordingListener listener);

}  // namespace handmap
