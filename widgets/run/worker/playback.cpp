#include "widgets/run/worker/playback.h"

#include <algorithm>

namespace handmap {

namespace {
constexpr int kFrameMs = 16;  // a drawn frame
}

Playback::Playback(QObject* parent) : QObject(parent) {
  timer_.setInterval(kFrameMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Playback::advance);
}

void Playback::setHistory(std::shared_ptr<const RunHistory> history) {
  history_ = std::move(history);
  index_.reset();
  loop_.reset();
  setPlaying(false);
  Q_EMIT changed();
}

void Playback::setSpeed(double speed) {
  speed_ = speed;
  startClock();
}

int Playback::index() const {
  if (index_) return *index_;
  return history_ ? history_->newest() : 0;
}

void Playback::seek(int index) {
  if (!history_ || history_->empty()) return;
  setPlaying(false);
  index >= history_->newest() ? toNewest() : show(std::max(index, history_->first()));
}

void Playback::toNewest() {
  setPlaying(false);
  if (!history_ || !index_) return;
  index_.reset();
  if (const auto newest = history_->at(history_->newest())) Q_EMIT shown(newest);
  Q_EMIT changed();
}

void Playback::play() {
  if (!history_ || history_->empty()) return;
  if (!index_ && !loop_) return Q_EMIT caughtUp();
  if (loop_ && (!index_ || *index_ < loop_->first || *index_ >= loop_->last)) show(loop_->first);
  startClock();
  setPlaying(true);
}

void Playback::pause() { setPlaying(false); }

void Playback::stepBack() {
  if (!history_ || history_->empty()) return;
  const int before = history_->at(index() - 1)->index;
  setPlaying(false);
  show(before);
}

void Playback::stepOn() {
  if (index_) seek(next(*index_));
}

/// The next one that the history has.
int Playback::next(int index) const {
  const int newest = history_->newest();
  while (++index < newest && history_->at(index)->index < index) {
  }
  return std::min(index, newest);
}

double Playback::timeOf(int index) const { return history_->at(index)->report.time_s; }

void Playback::startClock() {
  if (!index_) return;
  clock_begin_s_ = timeOf(*index_);
  clock_.start();
}

void Playback::advance() {
  if (!history_ || !index_) return setPlaying(false);
  const double now_s = clock_begin_s_ + 1e-3 * static_cast<double>(clock_.elapsed()) * speed_;
  const int to = speed_ > 0.0 ? std::max(*index_, history_->indexAt(now_s)) : next(*index_);
  if (loop_ && to >= loop_->last) {
    show(loop_->first);
    startClock();
  } else if (to >= history_->newest()) {
    toNewest();
    Q_EMIT caughtUp();
  } else if (to != *index_) {
    show(to);
  }
}

void Playback::show(int index) {
  const auto snapshot = history_->at(index);
  const bool was_newest = !index_;
  index_ = snapshot->index;
  Q_EMIT shown(snapshot);
  if (was_newest) Q_EMIT changed();
}

void Playback::setPlaying(bool playing) {
  if (playing == playing_) return;
  playing_ = playing;
  playing ? timer_.start() : timer_.stop();
  Q_EMIT changed();
}

}  // namespace handmap
