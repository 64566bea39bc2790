#include "core/method/conclusions.h"

#include <algorithm>
#include <utility>

#include <malloc.h>

#include "core/base/parallel.h"

namespace handmap {

using namespace method;

std::optional<Conclusion> Conclusions::take() {
  const bool is_ready =
      made_.valid() && made_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  if (!is_ready) return std::nullopt;
  Made made = made_.get();
  begin_at_ = now_() + kRest * made.took;
  if (trouble_.empty()) trouble_ = made.trouble;
  return std::move(made.conclusion);
}

void Conclusions::begin(double driven_m, const std::function<Make()>& know) {
  if (made_.valid() || driven_m < begin_at_m_ || now_() < begin_at_) return;
  begin_at_m_ = driven_m + std::max(kStretch_m, kStretchShare * driven_m);
  std::promise<Made> promise;
  made_ = promise.get_future();
  thread_ = std::jthread([make = know(), now = now_,
                          promise = std::move(promise)](const std::stop_token& stop) mutable {
    const auto begun = now();
    Made made;
    try {
      // One thread: the run itself has the others.
      made.conclusion = Arena(1).execute([&] { return make(stop); });
    } catch (const std::exception& error) {
      made.trouble = error.what();
    }
    make = nullptr;  // with its copy of what was known
    malloc_trim(0);  // both have taken a lot for a moment
    made.took = now() - begun;
    promise.set_value(std::move(made));
  });
}

void Conclusions::end() {
  thread_ = {};
  made_ = {};
}

}  // namespace handmap
