// Tables to scans and poses.
#pragma once

#include "core/logs/table.h"

namespace handmap {

/// Adds what the table holds: a scan a row, a point a row, or a pose a row.
void addTable(const Table& table, const LogOptions& options, Log& log);

/// CARMEN's lines: FLASER, ROBOTLASER1, ODOM. Whether `content` begins like such a log.
bool isCarmen(std::string_view content);
void addCarmen(std::string_view content, const std::string& file, const LogOptions& options,
               const std::stop_token& stop, Log& log);

}  // namespace handmap
