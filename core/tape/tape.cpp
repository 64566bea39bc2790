#include "core/tape/tape.h"

#include <algorithm>
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

std::size_t memoryOf(const Tape::Entry& entry) {
  return sizeof(Tape::Entry) + (entry.perceived ? bytesOf(*entry.perceived) : 0);
}

}  // namespace

Tape::Tape(std::unique_ptr<ObservationSource> source, const PerceptionOptions& options,
           const TapeLimits& limits)
    : info_(source->info()),
      local_map_(options.local_map),
      limits_(limits),
      source_(std::move(source)),
      perception_(info_, options) {}

std::optional<Tape::Taken> Tape::take(std::size_t n, const std::stop_token& stop) {
  const auto kept = [&]() -> std::optional<Taken> {
    const std::scoped_lock lock(mutex_);
    if (n >= first_ + slots_.size()) return std::nullopt;
    Entry entry = n < first_ ? Entry() : slots_[n - first_].entry;
    if (!entry.perceived && !entry.skipped) entry.perceived = perceivedAt(n);
    if (!entry.perceived && !entry.skipped) {
      throw Error(ErrorCode::RunFailed, phrase("the beginning of the run is no longer kept"),
                  phrase("run its recording with the changed drawing"));
    }
    return Taken{std::move(entry), {}, false};
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
    percept->walls.shrink_to_fit();
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
  {
    const std::scoped_lock lock(mutex_);
    if (entry.perceived) {
      const Observation& observation = entry.perceived->observation;
      odometry_.push_back({observation.time_s, observation.odometry});
    }
    memory_ += memoryOf(entry);
    slots_.push_back({std::move(entry), {}});
  }
  moveToDisk();
}

/// Who writes is the only one who changes what is in memory; nobody who reads waits for the disk.
void Tape::moveToDisk() {
  for (; memory_ > limits_.memory && on_disk_ + 1 < first_ + slots_.size(); ++on_disk_) {
    Slot& slot = slots_[on_disk_ - first_];
    std::optional<TapeFile::Place> place = TapeFile::Place();
    if (slot.entry.perceived) {
      place = limits_.disk > 0 ? file_.add(packed(*slot.entry.perceived)) : std::nullopt;
    }
    const std::scoped_lock lock(mutex_);
    memory_ -= memoryOf(slot.entry);
    slot.entry.perceived.reset();
    memory_ += memoryOf(slot.entry);
    if (place) {
      slot.place = *place;
      disk_ += place->bytes;
      while (disk_ > limits_.disk) dropBefore(first_ + 1);
    } else {
      dropBefore(on_disk_ + 1);
    }
  }
}

void Tape::dropBefore(std::size_t n) {
  for (; first_ < n; ++first_) {
    memory_ -= memoryOf(slots_.front().entry);
    disk_ -= slots_.front().place.bytes;
    file_.forget(slots_.front().place);
    slots_.pop_front();
  }
}

std::shared_ptr<const Perceived> Tape::perceivedAt(std::size_t n) const {
  if (n < first_ || n >= first_ + slots_.size()) return nullptr;
  const Slot& slot = slots_[n - first_];
  if (slot.entry.perceived || slot.place.bytes == 0) return slot.entry.perceived;
  return unpacked(file_.read(slot.place));
}

std::shared_ptr<const Perceived> Tape::at(std::size_t n) const {
  const std::scoped_lock lock(mutex_);
  return perceivedAt(n);
}

LocalMap Tape::localMap(std::size_t n) const {
  LocalMapBuilder builder(info_.range_limit_m, local_map_);
  LazyLocalMap map;
  for (std::size_t i = n - std::min(n, perception::kMostScans - 1); i <= n; ++i) {
    const auto perceived = at(i);
    if (!perceived) continue;
    const Observation& observation = perceived->observation;
    map = builder.add(observation.odometry, observation.standing, perceived->percept.walls);
  }
  return map ? map.get() : LocalMap(local_map_.cell_m, info_.range_limit_m);
}

std::size_t Tape::end() const {
  const std::scoped_lock lock(mutex_);
  return first_ + slots_.size();
}

std::size_t Tape::begin() const {
  const std::scoped_lock lock(mutex_);
  return first_;
}

std::size_t Tape::memory() const {
  const std::scoped_lock lock(mutex_);
  return memory_;
}

std::size_t Tape::disk() const {
  const std::scoped_lock lock(mutex_);
  return disk_;
}

std::vector<StampedPose> Tape::odometry() const {
  const std::scoped_lock lock(mutex_);
  return odometry_;
}

}  // namespace handmap
