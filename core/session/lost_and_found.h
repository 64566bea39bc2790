// When it is no longer known where a robot is that was known, and when it is known again.
#pragma once

#include <utility>

#include "core/method/pose_trust.h"

namespace handmap {

class LostAndFound {
 public:
  enum class News { None, Lost, Found };

  /// Of one snapshot after the other.
  News hear(Certainty certainty) {
    const bool lost = was_found_ && certainty == Certainty::Lost;
    was_found_ |= certainty != Certainty::Lost;
    if (std::exchange(is_lost_, lost) == lost) return News::None;
    return lost ? News::Lost : News::Found;
  }

 private:
  bool was_found_ = false;
  bool is_lost_ = false;
};

}  // namespace handmap
