// Conclusions while a run goes on, each made in a thread of its own from what is known so far.
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <stop_token>
#include <thread>

#include "core/session/conclusion.h"

namespace handmap {

/// By the way that the robot has gone, so that the same observations give the same conclusions at
/// the same moments however fast the machine is: one is begun whenever the way is half as long
/// again, and taken a tenth of the way later.
class Conclusions {
 public:
  /// Makes one; runs in the other thread.
  using Make = std::function<std::optional<Conclusion>(const std::stop_token&)>;

  /// Before each observation. Where one is due waits for it; nullopt where none is, or `stop` was
  /// requested (`isDue()` then still is).
  std::optional<Conclusion> take(double way_m, const std::stop_token& stop);
  bool isDue(double way_m) const { return made_.valid() && way_m >= take_at_m_; }
  /// Begins the next one where it is time; `know` is then asked for what makes it.
  void begin(double way_m, const std::function<Make()>& know);

 private:
  static constexpr double kFirst_m = 20.0;
  static constexpr double kLonger = 1.5;
  static constexpr double kLater = 1.1;

  double begin_at_m_ = kFirst_m;
  double take_at_m_ = 0.0;
  std::future<std::optional<Conclusion>> made_;
  std::jthread thread_;  ///< last: ends before what it writes to
};

}  // namespace handmap
