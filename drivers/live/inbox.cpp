#include "drivers/live/inbox.h"

#include <iterator>
#include <utility>

namespace handmap {

std::size_t Inbox::put(std::vector<Observation> observations) {
  std::size_t replaced = 0;
  {
    const std::scoped_lock lock(mutex_);
    if (closed_) return 0;
    replaced = newest_.size();
    newest_.assign(std::move_iterator(observations.begin()),
                   std::move_iterator(observations.end()));
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
  changed_.wait(lock, stop, [this] { return !newest_.empty() || closed_; });
  if (stop.stop_requested() || newest_.empty()) return std::nullopt;
  std::optional<Observation> oldest = std::move(newest_.front());
  newest_.pop_front();
  return oldest;
}

}  // namespace handmap
