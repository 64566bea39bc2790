// Where a run is written until it is whole: an older file stays as it was.
#pragma once

#include <filesystem>
#include <optional>

namespace handmap {

/// "run.part.mcap" of "run.mcap": the ending tells how it is written.
std::filesystem::path runPartOf(const std::filesystem::path& path);

/// What a run that something ended has left where `path` is to be written now: finished
/// (core/bags/mcap_writer.h) and named "run.unfinished.mcap". nullopt: nothing that can be read.
/// Throws RunFailed.
std::optional<std::filesystem::path> keepUnfinished(const std::filesystem::path& path);

/// The part takes its place. Throws RunFailed.
void takePlace(const std::filesystem::path& path);

}  // namespace handmap
