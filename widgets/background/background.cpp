#include "widgets/background/background.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

#include <condition_variable>
#include <thread>

namespace handmap {

namespace {

/// Of the process, as its threads are. Never destroyed: a thread may outlive main().
struct Running {
  std::mutex mutex;
  std::condition_variable one_ended;
  int count = 0;
};

Running& running() {
  static auto* const kRunning = new Running;
  return *kRunning;
}

/// The window comes first. What this thread starts (TBB's threads) inherits it.
void giveWay() {
#ifdef __linux__
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, 0, kNice);  // of this thread alone
#endif
}

void count(int change) {
  const std::scoped_lock lock(running().mutex);
  running().count += change;
}

}  // namespace

void startInBackground(std::function<void()> work) {
  count(1);
  try {
    std::thread([work = std::move(work)]() mutable {
      giveWay();
      work();
      work = nullptr;  // what it owns goes before the thread counts as ended
      std::unique_lock lock(running().mutex);
      --running().count;
      std::notify_all_at_thread_exit(running().one_ended, std::move(lock));
    }).detach();
  } catch (...) {
    count(-1);
    throw;
  }
}

bool waitForBackground(std::chrono::milliseconds patience) {
  std::unique_lock lock(running().mutex);
  return running().one_ended.wait_for(lock, patience, [] { return running().count == 0; });
}

}  // namespace handmap
