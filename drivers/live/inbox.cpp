#include "drivers/live/inbox.h"

#include <utility>

namespace handmap {

bool Inbox::put(Observation observation) {
  bool replaced = false;
  {
    const std::scoped_lock lock(mutex_);
    if (closed_) return false;
    replaced = newest_.has_value();
    newest_ = std::move(observation);
  }
  changed_.notify_all();
  return replaced;
}

void Inbox::close() {
  {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
}

std::optional<Observation> Inbox::take(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, stop, [this] { return newest_.has_value() || closed_; });
  if (stop.stop_requested()) return std::nullopt;
  return std::exchange(newest_, std::nullopt);
}

}  // namespace handmap
