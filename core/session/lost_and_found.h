// When it is no longer known where a robot is that was known, and when it is known again.
#pragma once

#include <utility>

#include "core/method/pose_trust.h"

namespace handmap {

class LostAndFound {
 public:
  enum class News { None, Lost, Found };

  /// Of one snapshot after the other. Where a robot starts is known, unless what it sees is against
  /// it.
  News hear(const FrameReport& report) {
    const bool is_lost = certaintyOf(report).kind == Certainty::Lost;
    was_found_ |= !is_lost || report.start_refuted;
    const bool lost = was_found_ && is_lost;
    if (std::exchange(is_lost_, lost) == lost) return News::None;
    return lost ? News::Lost : News::Found;
  }

 private:
  bool was_found_ = false;
  bool is_lost_ = false;
};

}  // namespace handmap
