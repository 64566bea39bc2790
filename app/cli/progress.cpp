#include "app/cli/progress.h"

#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

namespace handmap {

namespace {

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

Progress::Progress(int frames) : frames_(frames), terminal_(isatty(STDERR_FILENO) != 0) {}

double Progress::secondsSince(Clock::time_point time) const {
  return std::chrono::duration<double>(Clock::now() - time).count();
}

void Progress::clearLine() const {
  if (terminal_ && any_shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::update(int frames_done, double share) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock || secondsSince(shown_) < (terminal_ ? 0.1 : 2.0)) return;
  const double done = frames_done + share;
  if (done <= 0.0) return;
  clearLine();
  shown_ = Clock::now();
  any_shown_ = true;
  const double rate = done / secondsSince(begin_);
  const char* const end = terminal_ ? "" : "\n";
  if (frames_ == 0) {
    fmt::print(stderr, "frame {}, {:.1f} frames/s{}", frames_done, rate, end);
  } else {
    fmt::print(stderr, "frame {}/{}, {:.1f} frames/s, {} left{}", frames_done, frames_, rate,
               duration((frames_ - done) / rate), end);
  }
}

void Progress::message(const std::string& text) {
  const std::lock_guard lock(mutex_);
  clearLine();
  fmt::print(stderr, "handmap-cli: {}\n", text);
}

void Progress::finish(int frames_done) {
  const std::lock_guard lock(mutex_);
  if (!any_shown_) return;
  clearLine();
  const double seconds = secondsSince(begin_);
  const std::string of_all = frames_ == 0 ? "" : fmt::format(" of {}", frames_);
  fmt::print(stderr, "{}{} frames in {:.1f} s, {:.1f} frames/s\n", frames_done, of_all, seconds,
             frames_done / seconds);
}

}  // namespace handmap
