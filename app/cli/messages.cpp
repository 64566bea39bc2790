#include "app/cli/messages.h"

#include <fmt/format.h>

namespace handmap {

int complain(const Error& error) {
  fmt::print(stderr, "handmap-cli: error: {}\n", error.what());
  if (!error.hint().empty()) fmt::print(stderr, "hint: {}\n", error.hint());
  return static_cast<int>(error.code());
}

int complain(const Doubts& doubts) {
  int status = 0;
  for (const Doubt& doubt : doubts) {
    if (doubt.certain) {
      status = complain(Error(ErrorCode::BadInput, doubt.message, doubt.hint));
    } else {
      fmt::print(stderr, "handmap-cli: warning: {}\nhint: {}\n", doubt.message, doubt.hint);
    }
  }
  return status;
}

}  // namespace handmap
