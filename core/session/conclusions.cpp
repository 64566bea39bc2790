#include "core/session/conclusions.h"

#include <chrono>

#include "core/base/parallel.h"

namespace handmap {

std::optional<Conclusion> Conclusions::take() {
  const bool is_ready =
      made_.valid() && made_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  return is_ready ? made_.get() : std::nullopt;
}

void Conclusions::begin(double way_m, const std::function<Make()>& know) {
  if (made_.valid() || way_m < begin_at_m_) return;
  begin_at_m_ = kLonger * way_m;
  std::promise<std::optional<Conclusion>> promise;
  made_ = promise.get_future();
  thread_ = std::jthread(
      [make = know(), promise = std::move(promise)](const std::stop_token& stop) mutable {
        // One thread: the run itself has the others.
        try {
          promise.set_value(Arena(1).execute([&] { return make(stop); }));
        } catch (...) {
          promise.set_exception(std::current_exception());
        }
      });
}

}  // namespace handmap
