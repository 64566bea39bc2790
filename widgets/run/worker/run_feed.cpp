#include "widgets/run/worker/run_feed.h"

#include <utility>

namespace handmap {

RunFeed::RunFeed(Open open, PerceptionOptions perception)
    : open_(std::move(open)), perception_(std::move(perception)) {}

std::shared_ptr<Tape> RunFeed::open(const std::function<void(double)>& progress) {
  if (auto known = tape()) return known;
  auto source = open_(stop_.get_token(), progress);
  if (!source) return nullptr;
  auto opened =
      std::make_shared<Tape>(std::move(source), perception_, kMostBytes, stop_.get_token());
  const std::scoped_lock lock(mutex_);
  tape_ = std::move(opened);
  return tape_;
}

std::shared_ptr<Tape> RunFeed::tape() const {
  const std::scoped_lock lock(mutex_);
  return tape_;
}

}  // namespace handmap
