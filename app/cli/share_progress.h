// How far something is that is not a run, on stderr.
#pragma once

#include <chrono>
#include <string>

namespace handmap {

/// On a terminal one line that is written over, elsewhere a line every two seconds. Of one thread.
class ShareProgress {
 public:
  ShareProgress();
  ~ShareProgress();  ///< leaves no unfinished line
  ShareProgress(const ShareProgress&) = delete;
  ShareProgress& operator=(const ShareProgress&) = delete;

  /// `share` done of what is called `stage`, 0 … 1.
  void update(const std::string& stage, double share);

 private:
  bool terminal_;
  bool any_shown_ = false;
  std::chrono::steady_clock::time_point shown_;
};

}  // namespace handmap
