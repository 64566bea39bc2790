// A value that is made when somebody reads it, and then once. Copies share it; any thread may read.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace handmap {

template <typename T>
class Lazy {
 public:
  Lazy() = default;  ///< none
  explicit Lazy(std::function<T()> make) : state_(std::make_shared<State>(std::move(make))) {}
  explicit operator bool() const { return state_ != nullptr; }
  const T& get() const {
    std::call_once(state_->once, [this] {
      state_->value = state_->waiting()();
      state_->forget();
    });
    return *state_->value;
  }
  const T& operator*() const { return get(); }
  const T* operator->() const { return &get(); }
  /// One that keeps what is made to itself: who reads the copy leaves this one as small as it is.
  /// Of one that was read, the same one.
  Lazy again() const {
    std::function<T()> make = state_ ? state_->waiting() : nullptr;
    return make ? Lazy(std::move(make)) : *this;
  }
  bool operator==(const Lazy&) const = default;  ///< the same one, not only an equal one

 private:
  class State {
   public:
    explicit State(std::function<T()> make) : make_(std::move(make)) {}
    /// What makes the value; empty once it is there.
    std::function<T()> waiting() const {
      const std::scoped_lock lock(mutex_);
      return make_;
    }
    /// What it was made of may go.
    void forget() {
      std::function<T()> made;  // it goes without the lock
      const std::scoped_lock lock(mutex_);
      made.swap(make_);
    }

    std::once_flag once;
    std::optional<T> value;

   private:
    mutable std::mutex mutex_;
    std::function<T()> make_;
  };
  std::shared_ptr<State> state_;
};

}  // namespace handmap
