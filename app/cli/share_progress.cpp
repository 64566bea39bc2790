#include "app/cli/share_progress.h"

#include <fmt/format.h>
#include <unistd.h>

namespace handmap {

using Clock = std::chrono::steady_clock;

ShareProgress::ShareProgress() : terminal_(isatty(STDERR_FILENO) != 0), shown_(Clock::now()) {}

ShareProgress::~ShareProgress() {
  if (terminal_ && any_shown_) fmt::print(stderr, "\r\033[K");
}

void ShareProgress::update(const std::string& stage, double share) {
  const std::chrono::duration<double> since = Clock::now() - shown_;
  if (since.count() < (terminal_ ? 0.1 : 2.0)) return;
  shown_ = Clock::now();
  any_shown_ = true;
  fmt::print(stderr, "{}{}: {:.0f} %{}", terminal_ ? "\r\033[K" : "", stage, 100.0 * share,
             terminal_ ? "" : "\n");
}

}  // namespace handmap
