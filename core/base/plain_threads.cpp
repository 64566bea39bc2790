#include "core/base/plain_threads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace handmap::plain {

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body) {
  const auto most = static_cast<std::size_t>(std::clamp(team.threads, 1, kMostThreads));
  const std::size_t members = team.divided ? 1 : std::min(most, count);
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto work = [&](Team as) {
    const Team before = std::exchange(team, as);
    try {
      for (std::size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
    team = before;
  };
  std::vector<std::thread> others;
  for (std::size_t member = 1; member < members; ++member) {
    others.emplace_back(work, Team{team.threads, static_cast<int>(member), true});
  }
  work({team.threads, team.member, team.divided || members > 1});
  for (std::thread& other : others) other.join();
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace handmap::plain
