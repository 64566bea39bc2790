#include "widgets/run/worker/run_feed.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <utility>

#include "widgets/background/background.h"

namespace handmap {

namespace {

constexpr auto kLookAgain = std::chrono::milliseconds(20);

}  // namespace

struct RunFeed::State {
  void waitForOthers() const {
    while (others.valid() && !stop.stop_requested() &&
           others.wait_for(kLookAgain) != std::future_status::ready) {
    }
  }

  void close() {
    const std::scoped_lock lock(opening);  // who opens it has been told to stop
    if (tape) tape->close();
    closing.set_value();
  }

  Open open;
  PerceptionOptions perception;
  Closed others;
  std::stop_source stop;
  std::atomic<bool> is_ended = false;
  std::promise<void> closing;
  Closed closed = closing.get_future().share();
  std::mutex opening;  // one opens or closes at a time; taken before mutex
  std::mutex mutex;
  std::shared_ptr<Tape> tape;  // written under both
};

RunFeed::RunFeed(Open open, PerceptionOptions perception, Closed others)
    : state_(std::make_shared<State>()) {
  state_->open = std::move(open);
  state_->perception = std::move(perception);
  state_->others = std::move(others);
}

RunFeed::~RunFeed() { end(); }

std::shared_ptr<Tape> RunFeed::open(const std::function<void(double)>& progress) {
  State& state = *state_;
  const std::scoped_lock opening(state.opening);
  if (state.tape) return state.tape;
  state.waitForOthers();
  if (state.stop.stop_requested()) return nullptr;
  auto source = state.open(state.stop.get_token(), progress);
  if (!source) return nullptr;
  auto opened =
      std::make_shared<Tape>(std::move(source), state.perception, TapeLimits::toDoAgain());
  const std::scoped_lock lock(state.mutex);
  state.tape = std::move(opened);
  return state.tape;
}

std::shared_ptr<Tape> RunFeed::tape() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->tape;
}

void RunFeed::end() {
  state_->stop.request_stop();
  if (state_->is_ended.exchange(true)) return;
  startInBackground([state = state_] { state->close(); });
}

RunFeed::Closed RunFeed::closed() const { return state_->closed; }

}  // namespace handmap
