#include "widgets/background/failure.h"

namespace handmap {

Failure failureOf(const Error& error) {
  return {error.code(), QString::fromStdString(error.what()), QString::fromStdString(error.hint())};
}

}  // namespace handmap
