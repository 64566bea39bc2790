// The place for the newest observations, between the thread of the rig and that of the run.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/recording/observation.h"

namespace handmap {

class Inbox {
 public:
  /// What became whole at the same time. Returns how many that nobody has taken made way for them.
  std::size_t put(std::vector<Observation> observations);
  /// No more will come; what is there can still be taken.
  void close();
  /// Waits. nullopt when `stop` was requested, and after close() when there is none.
  std::optional<Observation> take(const std::stop_token& stop);

 private:
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Observation> newest_;
  bool closed_ = false;
};

}  // namespace handmap
