// The table of a recording: frames.csv.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/recording/recording.h"

namespace handmap {

/// A day at more than ten views a second; a recording holds its table in memory.
inline constexpr std::size_t kMaxRows = 1'000'000;
/// They are one observation: all of their images are in memory together.
inline constexpr int kMaxRowsOfStop = 100;

/// Columns are found by their names; of them `frame` and `time_s` must be there. A column
/// `right_time_s` tells when the right image was taken. Checks that frames and times increase (rows
/// of one stop may share them) and that files lie inside the folder. Throws BadInput with the line.
std::vector<FrameRow> readFrameTable(const std::filesystem::path& path,
                                     const std::stop_token& stop = {});

/// The header line, with its line end.
std::string frameTableHeader();
std::string formatFrameRow(const FrameRow& row);

}  // namespace handmap
