#include "app/cli/messages.h"

#include <fmt/format.h>

namespace handmap {

int complain(const Error& error) {
  fmt::print(stderr, "handmap-cli: error: {}\n", error.what());
  if (!error.hint().empty()) fmt::print(stderr, "hint: {}\n", error.hint());
  return static_cast<int>(error.code());
}

}  // namespace handmap
