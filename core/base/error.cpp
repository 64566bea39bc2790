#include "core/base/error.h"

#include "core/base/phrase.h"

namespace handmap {

void throwBadInput(const std::string& file, const std::string& place, const std::string& found,
                   const std::string& expected) {
  throw Error(ErrorCode::BadInput,
              place.empty()
                  ? phrase("{}: found {}, expected {}", file, found, expected)
                  : phrase("{}: {}: found {}, expected {}", file, place, found, expected));
}

void throwIfStopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Error(ErrorCode::RunFailed, phrase("stopped"));
}

}  // namespace handmap
