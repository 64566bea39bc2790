#include "core/run_log/run_part.h"

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

std::filesystem::path runPartOf(const std::filesystem::path& path) {
  std::filesystem::path part = path;
  part.replace_extension(".part");
  part += path.extension();
  return part;
}

void takePlace(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::rename(runPartOf(path), path, error);
  if (!error) return;
  throw Error(ErrorCode::RunFailed,
              phrase("{}: cannot be written: {}", path.string(), error.message()));
}

}  // namespace handmap
