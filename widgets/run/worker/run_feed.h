// Where a run's observations come from: opened once, and kept while one run after another goes on
// with it.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>

#include "core/session/tape.h"

namespace handmap {

class RunFeed {
 public:
  /// Called in the thread of a run: opening may take its time, and tells the share done. The source
  /// must not wait for anything once the stop is requested; nullptr when it was requested before
  /// the source was open. Throws handmap::Error.
  using Open = std::function<std::unique_ptr<ObservationSource>(
      std::stop_token, const std::function<void(double)>&)>;

  RunFeed(Open open, PerceptionOptions perception);

  /// Opens it the first time. nullptr when the end was asked for before. In the thread of a run.
  std::shared_ptr<Tape> open(const std::function<void(double)>& progress);
  /// nullptr before it is open. From any thread; never waits for open().
  std::shared_ptr<Tape> tape() const;
  /// Nothing more is waited for, nothing more is perceived.
  void end() { stop_.request_stop(); }

 private:
  /// What may be gone over again: hours of a planar scanner, minutes of a spinning one.
  static constexpr std::size_t kMostBytes = 512U << 20U;

  Open open_;
  PerceptionOptions perception_;
  std::stop_source stop_;
  mutable std::mutex mutex_;
  std::shared_ptr<Tape> tape_;  // under mutex_
};

}  // namespace handmap
