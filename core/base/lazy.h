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
  explicit Lazy(std::function<T()> make) : state_(std::make_shared<State>()) {
    state_->make = std::move(make);
  }
  explicit operator bool() const { return state_ != nullptr; }
  const T& get() const {
    std::call_once(state_->once, [this] {
      state_->value = state_->make();
      state_->make = nullptr;  // what it is made of may go
    });
    return *state_->value;
  }
  const T& operator*() const { return get(); }
  const T* operator->() const { return &get(); }
  /// One that keeps what is made to itself: who reads the copy leaves this one as small as it is.
  /// Only before anybody else has it; of one that was read, the same one.
  Lazy again() const { return state_ && state_->make ? Lazy(state_->make) : *this; }
  bool operator==(const Lazy&) const = default;  ///< the same one, not only an equal one

 private:
  struct State {
    std::function<T()> make;
    std::once_flag once;
    std::optional<T> value;
  };
  std::shared_ptr<State> state_;
};

}  // namespace handmap
