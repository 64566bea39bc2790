#include "core/session/run_history.h"

#include <algorithm>
#include <utility>

#include <malloc.h>

namespace handmap {

namespace {

constexpr double kFullest = 0.75;  // after thinning, so that it is not done at every snapshot

std::size_t bytesOf(const cv::Mat& image) { return image.total() * image.elemSize(); }

std::size_t pictureBytes(const Snapshot& snapshot) {
  return bytesOf(snapshot.image) + bytesOf(snapshot.disparity) + bytesOf(snapshot.buildings);
}

/// What is made of it by whoever reads it is its own. What was seen on the way there is not kept
/// for its local map: the tape has it.
Snapshot unread(const Snapshot& snapshot) {
  Snapshot copy = snapshot;
  copy.map = snapshot.map.again();
  copy.local_map = snapshot.seen.localMap();
  if (!copy.local_map) copy.local_map = snapshot.local_map.again();
  return copy;
}

void takePictures(Snapshot& to, const Snapshot& from) {
  to.image = from.image;
  to.disparity = from.disparity;
  to.buildings = from.buildings;
  to.pictured = from.pictured;
  to.panning = from.panning;
}

}  // namespace

RunHistory::RunHistory(const HistoryLimits& limits) : limits_(limits) {}

void RunHistory::add(const Snapshot& snapshot) {
  const std::scoped_lock lock(mutex_);
  if (const auto same = past_.find(snapshot.index); same != past_.end()) {
    picture_bytes_ -= pictureBytes(same->second);
  }
  Snapshot& kept = past_[snapshot.index] = unread(snapshot);
  picture_bytes_ += pictureBytes(kept);
  if (past_.size() > limits_.snapshots) thinSnapshots();
  if (picture_bytes_ > limits_.picture_bytes) thinPictures();
}

void RunHistory::borrowPictures(const RunHistory& other) {
  const std::scoped_lock lock(mutex_, other.mutex_);
  for (auto& [index, snapshot] : past_) {
    const auto same = other.past_.find(index);
    if (!snapshot.image.empty() || same == other.past_.end()) continue;
    takePictures(snapshot, same->second);
    picture_bytes_ += pictureBytes(snapshot);
  }
  if (!past_.empty() && picture_bytes_ > limits_.picture_bytes) thinPictures();
}

/// The first stays, and the newest until the next one comes.
void RunHistory::thinSnapshots() {
  const int first = past_.begin()->first;
  const int newest = past_.rbegin()->first;
  const auto most = static_cast<std::size_t>(kFullest * static_cast<double>(limits_.snapshots));
  while (past_.size() > std::max<std::size_t>(most, 2)) {
    std::erase_if(past_, [&](const auto& entry) {
      const bool goes = (entry.first - first) % step_ != 0 && entry.first != newest;
      if (goes) picture_bytes_ -= pictureBytes(entry.second);
      return goes;
    });
    if (past_.size() > most) step_ *= 2;
  }
  malloc_trim(0);  // what has gone lay between what stays: its pages go back to the system
}

void RunHistory::thinPictures() {
  const int first = past_.begin()->first;
  const auto newest = std::prev(past_.end());
  const auto most = static_cast<std::size_t>(kFullest * static_cast<double>(limits_.picture_bytes));
  while (picture_bytes_ > most) {
    for (auto entry = past_.begin(); entry != newest; ++entry) {
      if ((entry->first - first) % picture_step_ == 0) continue;
      picture_bytes_ -= pictureBytes(entry->second);
      takePictures(entry->second, Snapshot{});
    }
    if (picture_bytes_ <= most || picture_step_ > newest->first - first) return;
    picture_step_ *= 2;
  }
}

bool RunHistory::empty() const {
  const std::scoped_lock lock(mutex_);
  return past_.empty();
}

int RunHistory::first() const {
  const std::scoped_lock lock(mutex_);
  return past_.empty() ? 0 : past_.begin()->first;
}

int RunHistory::newest() const {
  const std::scoped_lock lock(mutex_);
  return past_.empty() ? 0 : past_.rbegin()->first;
}

std::shared_ptr<const Snapshot> RunHistory::at(int index) const {
  const std::scoped_lock lock(mutex_);
  if (past_.empty()) return nullptr;
  auto entry = past_.upper_bound(index);
  if (entry != past_.begin()) --entry;
  auto snapshot = std::make_shared<Snapshot>(unread(entry->second));
  while (entry->second.image.empty() && entry != past_.begin()) --entry;
  takePictures(*snapshot, entry->second);
  return snapshot;
}

int RunHistory::indexAt(double time_s) const {
  const std::scoped_lock lock(mutex_);
  if (past_.empty()) return 0;
  // Times increase with the index.
  int first = past_.begin()->first;
  for (const auto& [index, snapshot] : past_) {
    if (snapshot.report.time_s > time_s) break;
    first = index;
  }
  return first;
}

}  // namespace handmap
