// Conclusions while a run goes on, each made in a thread of its own from what is known so far.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "core/method/conclusion.h"
#include "core/method/constants.h"

namespace handmap {

/// One is begun after each stretch of the way, at least a tenth of it (what is known is copied for
/// it), and after a rest twice as long as the last one took: together they have a third of one
/// core. Nobody waits for them: one is there when it is there, and nothing else depends on it, so
/// that one that cannot be made is only told.
class Conclusions {
 public:
  /// Makes one; runs in the other thread.
  using Make = std::function<std::optional<Conclusion>(const std::stop_token&)>;
  using Clock = std::chrono::steady_clock;
  /// What time it is; asked by both threads.
  using Now = std::function<Clock::time_point()>;

  Conclusions() = default;
  explicit Conclusions(Now now) : now_(std::move(now)) {}

  /// One that is ready and was not taken yet.
  std::optional<Conclusion> take();
  /// Nothing more is wanted; waits for the thread.
  void end();
  /// Why the first that could not be made could not; empty: none.
  const std::string& trouble() const { return trouble_; }
  /// Begins the next one where it is time; `know` is then asked for what makes it.
  void begin(double driven_m, const std::function<Make()>& know);

 private:
  struct Made {
    std::optional<Conclusion> conclusion;
    std::string trouble;  ///< why there is none, if it should have been
    Clock::duration took{};
  };
  Now now_ = Clock::now;
  double begin_at_m_ = method::kStretch_m;
  Clock::time_point begin_at_{};
  std::string trouble_;
  std::future<Made> made_;
  std::jthread thread_;  ///< last: ends before what it writes to
};

}  // namespace handmap
