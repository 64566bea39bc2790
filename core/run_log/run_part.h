// Where a run is written until it is whole: an older file stays as it was.
#pragma once

#include <filesystem>

namespace handmap {

/// "run.part.mcap" of "run.mcap": the ending tells how it is written.
std::filesystem::path runPartOf(const std::filesystem::path& path);

/// The part takes its place. Throws RunFailed.
void takePlace(const std::filesystem::path& path);

}  // namespace handmap
