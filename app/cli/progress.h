// How far a run is, on stderr.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "app/cli/repeats.h"

namespace handmap {

enum class Verbosity { Usual, Quiet };

/// On a terminal a bar that is written over, elsewhere a line every two seconds: frame, rate and
/// remaining time. Quiet: nothing at all.
class Progress {
 public:
  /// 0 frames: nobody knows how many.
  explicit Progress(int frames, Verbosity verbosity = Verbosity::Usual);

  /// `share` of the next frame, 0 … 1. From any thread.
  void update(int frames_done, double share);
  /// Says something in a line of its own.
  void message(const std::string& text);
  /// The same; of those that differ in numbers alone three are said and the rest are counted.
  void repeatable(const std::string& text);
  /// The last word, if there was a first.
  void finish(int frames_done);

 private:
  using Clock = std::chrono::steady_clock;
  double secondsSince(Clock::time_point time) const;
  void clearLine() const;

  int frames_;
  Verbosity verbosity_;
  Repeats repeats_;
  bool terminal_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
  bool any_shown_ = false;
  std::mutex mutex_;
};

}  // namespace handmap
