// What core/base/parallel.h offers, by std::thread alone: for the thread sanitizer, not for speed.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <utility>

namespace handmap::plain {

inline constexpr int kMostThreads = 8;

/// How many threads may share the work that this thread divides, and which of them it is itself.
struct Team {
  int threads = 4;  ///< more than a small machine has: that is where races show
  int member = 0;
  bool divided = false;  ///< a part of divided work is not divided again
};
inline thread_local Team team;

/// As handmap::parallelFor().
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body);

class Arena {
 public:
  explicit Arena(int threads) : threads_(threads > 0 ? threads : Team().threads) {}

  template <typename Work>
  auto execute(Work&& work) {
    struct Restored {
      Team before = team;
      Restored() = default;
      Restored(const Restored&) = delete;
      Restored& operator=(const Restored&) = delete;
      ~Restored() { team = before; }
    };
    const Restored restored;
    team.threads = threads_;
    return std::forward<Work>(work)();
  }

 private:
  int threads_;
};

/// Of one owner: two teams must not share it at a time.
template <typename Value>
class PerThread {
 public:
  Value& local() { return values_[static_cast<std::size_t>(team.member)]; }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }

 private:
  std::array<Value, kMostThreads> values_{};
};

}  // namespace handmap::plain
