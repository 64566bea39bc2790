// Conclusions while a run goes on, each made in a thread of its own from what is known so far.
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <stop_token>
#include <thread>

#include "core/session/conclusion.h"

namespace handmap {

/// One is begun whenever the way is half as long again. Nobody waits for it: it is there when it is
/// there, and nothing else depends on it.
class Conclusions {
 public:
  /// Makes one; runs in the other thread.
  using Make = std::function<std::optional<Conclusion>(const std::stop_token&)>;

  /// One that is ready and was not taken yet.
  std::optional<Conclusion> take();
  /// Begins the next one where it is time; `know` is then asked for what makes it.
  void begin(double way_m, const std::function<Make()>& know);

 private:
  static constexpr double kFirst_m = 20.0;
  static constexpr double kLonger = 1.5;

  double begin_at_m_ = kFirst_m;
  std::future<std::optional<Conclusion>> made_;
  std::jthread thread_;  ///< last: ends before what it writes to
};

}  // namespace handmap
