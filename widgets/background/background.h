// Work in threads that nobody joins, and their way back to the object they work for. Who lets go of
// such work requests its stop and goes on at once; the thread ends by itself, and what it says
// after that is dropped.
#pragma once

#include <QMetaObject>
#include <QObject>
#include <chrono>
#include <functional>
#include <mutex>

namespace handmap {

/// Runs `work` in a thread of its own, which gives way to that of the window. It owns all that it
/// uses and does not throw.
void startInBackground(std::function<void()> work);

/// For the end of the program: waits until no such thread is left in this process, their
/// thread-local objects included. False: there still are some after `patience`.
bool waitForBackground(std::chrono::milliseconds patience);

/// What a thread holds of an object of the GUI thread that may go at any time.
template <typename Owner>
class Lifeline {
 public:
  explicit Lifeline(Owner& owner) : owner_(&owner) {}

  /// By the owner's destructor, first of all.
  void cut() {
    const std::scoped_lock lock(mutex_);
    owner_ = nullptr;
  }
  /// Calls `work(owner)` in the calling thread, unless the owner is gone; it cannot go meanwhile,
  /// so be brief.
  template <typename Work>
  void with(Work work) {
    const std::scoped_lock lock(mutex_);
    if (owner_ != nullptr) work(*owner_);
  }
  /// Calls `say(owner)` later, in the owner's thread, in the order of the calls; never when the
  /// owner is gone by then.
  template <typename Say>
  void post(Say say) {
    with([&say](Owner& owner) {
      QMetaObject::invokeMethod(
          &owner, [&owner, say = std::move(say)] { say(owner); }, Qt::QueuedConnection);
    });
  }

 private:
  std::mutex mutex_;
  Owner* owner_;
};

}  // namespace handmap
