// A deep check of a recording: reads every image and every points file.
#pragma once

#include <string>
#include <vector>

#include "core/recording/recording.h"

namespace handmap {

/// What a run over the whole recording would stumble upon, a line each; empty when all is well.
std::vector<std::string> problemsOf(const Recording& recording);

}  // namespace handmap
