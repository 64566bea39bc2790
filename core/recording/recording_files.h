// Which files are a recording's, so that no output takes the place of one.
#pragma once

#include <filesystem>
#include <optional>

namespace handmap {

enum class NewOdometry { Refused, Allowed };

/// The folder of the recording that a path leads into, links followed, to one of the files that the
/// format or its frames.csv names; letters of either case. nullopt for all else in such a folder.
std::optional<std::filesystem::path> recordingOf(const std::filesystem::path& file);

/// Throws BadInput "OUTPUT: is a file of the recording FOLDER, expected another place": whether it
/// is there or not, but for an odometry that the recording does not have, where that is allowed.
void refuseFileOfRecording(const std::filesystem::path& output,
                           NewOdometry odometry = NewOdometry::Refused);

}  // namespace handmap
