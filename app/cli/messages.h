// What handmap-cli says on stderr.
#pragma once

#include "core/base/error.h"
#include "core/plausibility/doubt.h"

namespace handmap {

/// Prints the error and its hint; returns the exit status.
int complain(const Error& error);

/// Prints what is likely not meant so: warnings, and errors where it cannot be; the exit status.
int complain(const Doubts& doubts);

}  // namespace handmap
