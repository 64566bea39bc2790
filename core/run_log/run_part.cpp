#include "core/run_log/run_part.h"

#include "core/bags/mcap_writer.h"
#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

/// "run.WORD.mcap" of "run.mcap".
std::filesystem::path besides(const std::filesystem::path& path, const char* word) {
  std::filesystem::path named = path;
  named.replace_extension(word);
  named += path.extension();
  return named;
}

void moveTo(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if (!error) return;
  throw Error(ErrorCode::RunFailed,
              phrase("{}: cannot be written: {}", to.string(), error.message()));
}

}  // namespace

std::filesystem::path runPartOf(const std::filesystem::path& path) {
  return besides(path, ".part");
}

std::optional<std::filesystem::path> keepUnfinished(const std::filesystem::path& path) {
  const std::filesystem::path part = runPartOf(path);
  if (!std::filesystem::is_regular_file(part)) return std::nullopt;
  try {
    finishMcap(part);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::BadInput) throw;
    return std::nullopt;
  }
  const std::filesystem::path kept = besides(path, ".unfinished");
  moveTo(part, kept);
  return kept;
}

void takePlace(const std::filesystem::path& path) { moveTo(runPartOf(path), path); }

}  // namespace handmap
