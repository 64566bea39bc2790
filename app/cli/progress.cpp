#include "app/cli/progress.h"

#include <algorithm>
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

/// Thirty characters and the share.
std::string bar(double share) {
  constexpr int kCells = 30;
  const int full = std::clamp(static_cast<int>(share * kCells), 0, kCells);
  return fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %  ", "", full, "", kCells - full, 100.0 * share);
}

}  // namespace

Progress::Progress(int frames, Verbosity verbosity)
    : frames_(frames), verbosity_(verbosity), terminal_(isatty(STDERR_FILENO) != 0) {}

double Progress::secondsSince(Clock::time_point time) const {
  return std::chrono::duration<double>(Clock::now() - time).count();
}

void Progress::clearLine() const {
  if (terminal_ && any_shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::update(int frames_done, double share) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock || verbosity_ == Verbosity::Quiet || secondsSince(shown_) < (terminal_ ? 0.1 : 2.0))
    return;
  // The end of a run has a share of its own, after the last frame.
  const double done =
      frames_ == 0 ? frames_done + share : std::min(frames_done + share, 1.0 * frames_);
  if (done <= 0.0) return;
  clearLine();
  shown_ = Clock::now();
  any_shown_ = true;
  const double rate = done / secondsSince(begin_);
  const char* const end = terminal_ ? "" : "\n";
  if (frames_ == 0) {
    fmt::print(stderr, "frame {}, {:.1f} frames/s{}", frames_done, rate, end);
  } else {
    if (terminal_) fmt::print(stderr, "{}", bar(done / frames_));
    fmt::print(stderr, "frame {}/{}, {:.1f} frames/s, {} left{}", frames_done, frames_, rate,
               duration((frames_ - done) / rate), end);
  }
}

void Progress::message(const std::string& text) {
  if (verbosity_ == Verbosity::Quiet) return;
  const std::lock_guard lock(mutex_);
  clearLine();
  fmt::print(stderr, "handmap-cli: {}\n", text);
}

void Progress::repeatable(const std::string& text) {
  bool is_news = false;
  {
    const std::lock_guard lock(mutex_);
    is_news = repeats_.isNews(text);
  }
  if (is_news) message(text);
}

void Progress::finish(int frames_done) {
  const std::lock_guard lock(mutex_);
  if (verbosity_ == Verbosity::Quiet) return;
  clearLine();
  fmt::print(stderr, "{}", repeats_.counted());
  if (!any_shown_) return;
  clearLine();
  const double seconds = secondsSince(begin_);
  const std::string of_all = frames_ == 0 ? "" : fmt::format(" of {}", frames_);
  fmt::print(stderr, "{}{} frames in {:.1f} s, {:.1f} frames/s\n", frames_done, of_all, seconds,
             frames_done / seconds);
}

}  // namespace handmap
