#include "core/session/tape.h"

#include <utility>

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

/// Of the last view with an image, which is the one that a percept has.
Panning panningOf(const std::vector<View>& views) {
  for (std::size_t i = views.size(); i-- > 0;) {
    if (views[i].left.empty()) continue;
    return {views[i].pan, static_cast<int>(i) + 1, static_cast<int>(views.size())};
  }
  return {};
}

std::size_t bytesOf(const Tape::Entry& entry) {
  if (!entry.perceived) return sizeof(Tape::Entry);
  const Percept& percept = entry.perceived->percept;
  // Of the local map, the wall points of its scan and the list of those before it: as measured.
  constexpr std::size_t kLocalMap = 14U << 10U;
  return sizeof(Perceived) + kLocalMap + percept.points.capacity() * sizeof(RangePoint) +
         percept.scan.rays.capacity() * sizeof(Ray);
}

}  // namespace

Tape::Tape(std::unique_ptr<ObservationSource> source, const PerceptionOptions& options,
           std::size_t most_bytes)
    : info_(source->info()),
      source_(std::move(source)),
      perception_(info_, options),
      most_bytes_(most_bytes) {}

std::optional<Tape::Taken> Tape::take(std::size_t n, const std::stop_token& stop) {
  const auto kept = [&]() -> std::optional<Taken> {
    const std::scoped_lock lock(mutex_);
    if (n >= first_ + entries_.size()) return std::nullopt;
    if (n < first_) {
      throw Error(ErrorCode::RunFailed, phrase("the beginning of the run is no longer in memory"),
                  phrase("run its recording with the changed drawing"));
    }
    return Taken{entries_[n - first_], {}, false};
  };
  if (auto taken = kept()) return taken;
  const std::scoped_lock lock(source_mutex_);
  if (auto taken = kept()) return taken;  // somebody else has read it meanwhile
  if (stop.stop_requested() || closing_.stop_requested()) return std::nullopt;
  std::stop_source either;
  const auto interrupt = [&either] { either.request_stop(); };
  const std::stop_callback on_stop(stop, interrupt);
  const std::stop_callback on_closing(closing_.get_token(), interrupt);
  auto taken = perceive(either.get_token());
  if (taken) keep(taken->entry);
  return taken;
}

std::optional<Tape::Taken> Tape::perceive(const std::stop_token& stop) {
  Taken taken;
  taken.from_now = true;
  const auto skip = [&](int frame, const char* reason) {
    taken.entry.skipped = SkippedFrame{frame, reason};
    return taken;
  };
  try {
    if (!waiting_ && source_) waiting_ = source_->next();
  } catch (const FrameError& error) {
    return skip(error.frame(), error.what());
  }
  if (!waiting_ || stop.stop_requested()) return std::nullopt;
  std::optional<Observation> observation;
  try {
    std::optional<Percept> percept = perception_(*waiting_, stop);
    if (!percept) return std::nullopt;
    observation = std::exchange(waiting_, std::nullopt);
    taken.pictures = {percept->image, percept->disparity, percept->buildings,
                      panningOf(observation->views)};
    percept->image = cv::Mat();
    percept->disparity = cv::Mat1f();
    percept->buildings = cv::Mat1f();
    percept->points.shrink_to_fit();
    percept->scan.rays.shrink_to_fit();
    observation->views.clear();
    taken.entry.perceived =
        std::make_shared<const Perceived>(Perceived{std::move(*observation), std::move(*percept)});
  } catch (const Error& error) {
    const int frame = waiting_->frame;
    waiting_.reset();
    return skip(frame, error.what());
  }
  return taken;
}

void Tape::close() {
  closing_.request_stop();
  const std::scoped_lock lock(source_mutex_);
  waiting_.reset();
  source_.reset();
}

void Tape::keep(Entry entry) {
  const std::scoped_lock lock(mutex_);
  if (entry.perceived) {
    const Observation& observation = entry.perceived->observation;
    odometry_.push_back({observation.time_s, observation.odometry});
  }
  bytes_ += bytesOf(entry);
  entries_.push_back(std::move(entry));
  while (bytes_ > most_bytes_ && !entries_.empty()) {
    bytes_ -= bytesOf(entries_.front());
    entries_.pop_front();
    ++first_;
  }
}

std::size_t Tape::end() const {
  const std::scoped_lock lock(mutex_);
  return first_ + entries_.size();
}

std::size_t Tape::begin() const {
  const std::scoped_lock lock(mutex_);
  return first_;
}

std::vector<std::shared_ptr<const Perceived>> Tape::all() const {
  const std::scoped_lock lock(mutex_);
  std::vector<std::shared_ptr<const Perceived>> perceived;
  for (const Entry& entry : entries_) {
    if (entry.perceived) perceived.push_back(entry.perceived);
  }
  return perceived;
}

std::vector<StampedPose> Tape::odometry() const {
  const std::scoped_lock lock(mutex_);
  return odometry_;
}

}  // namespace handmap
