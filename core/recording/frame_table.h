// The table of a recording: frames.csv.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/recording/recording.h"

namespace handmap {

/// Columns are found by their names; of them `frame` and `time_s` must be there. A column
/// `right_time_s` tells when the right image was taken. Checks that frames and times increase (rows
/// of one stop may share them) and that files lie inside the folder. Throws BadInput with the line.
std::vector<FrameRow> readFrameTable(const std::filesystem::path& path);

/// The header line, with its line end.
std::string frameTableHeader();
std::string formatFrameRow(const FrameRow& row);

}  // namespace handmap
