// How far a run is, on stderr.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace handmap {

/// On a terminal one line that is written over, elsewhere a line every two seconds: frame, rate and
/// remaining time.
class Progress {
 public:
  /// 0 frames: nobody knows how many.
  explicit Progress(int frames);

  /// `share` of the next frame, 0 … 1. From any thread.
  void update(int frames_done, double share);
  /// Says something in a line of its own.
  void message(const std::string& text);
  /// The last word, if there was a first.
  void finish(int frames_done);

 private:
  using Clock = std::chrono::steady_clock;
  double secondsSince(Clock::time_point time) const;
  void clearLine() const;

  int frames_;
  bool terminal_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
  bool any_shown_ = false;
  std::mutex mutex_;
};

}  // namespace handmap
