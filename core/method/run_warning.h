// What went wrong without ending a run: it has an end and a map, and nobody was helped by it.
#pragma once

#include <string>

namespace handmap {

struct RunWarning {
  std::string code;     ///< stable, for programs: see runWarnings()
  std::string message;  ///< what was looked at, and what was missing
  std::string hint;     ///< what to try
};

}  // namespace handmap
