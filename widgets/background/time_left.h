// How long work that tells the share done will still take.
#pragma once

#include <QString>
#include <optional>

namespace handmap {

class TimeLeft {
 public:
  void begin() { *this = {}; }
  /// Told that `share` (0 … 1) is done, `now_s` on any clock that only goes on. A smaller share
  /// than before is the beginning of other work.
  void update(double share, double now_s);
  /// Seconds; nullopt until enough is done to tell.
  std::optional<double> seconds() const { return left_s_; }
  /// ", about 12 s left", or nothing.
  QString inWords() const;

 private:
  std::optional<double> begin_s_;
  double first_ = 0.0;
  double last_ = 0.0;
  std::optional<double> left_s_;
};

/// Of the same clock everywhere, seconds.
double steadySeconds();

}  // namespace handmap
