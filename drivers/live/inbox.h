// One place for the newest observation, between the thread of the rig and that of the run.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>

#include "core/recording/observation.h"

namespace handmap {

class Inbox {
 public:
  /// True: one that nobody has taken made way for it.
  bool put(Observation observation);
  /// No more will come; what is there can still be taken.
  void close();
  /// Waits. nullopt when `stop` was requested, and after close() when there is none.
  std::optional<Observation> take(const std::stop_token& stop);

 private:
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Observation> newest_;
  bool closed_ = false;
};

}  // namespace handmap
