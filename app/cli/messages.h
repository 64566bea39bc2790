// What handmap-cli says on stderr.
#pragma once

#include "core/base/error.h"

namespace handmap {

/// Prints the error and its hint; returns the exit status.
int complain(const Error& error);

}  // namespace handmap
