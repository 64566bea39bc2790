#include "core/base/error.h"

#include <fmt/format.h>

namespace handmap {

void throwBadInput(const std::string& file, const std::string& place, const std::string& found,
                   const std::string& expected) {
  throw Error(ErrorCode::BadInput, fmt::format("{}: {}{}found {}, expected {}", file, place,
                                               place.empty() ? "" : ": ", found, expected));
}

void throwIfStopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Error(ErrorCode::RunFailed, "stopped");
}

}  // namespace handmap
