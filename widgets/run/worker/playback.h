// What of a run is looked at: its newest state, or a moment of its past, which can be played again
// at the pace of the recording's clock. Nothing is computed here.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "core/session/run_history.h"

namespace handmap {

struct PlayRange {
  int first;
  int last;
};

class Playback : public QObject {
  Q_OBJECT
 public:
  explicit Playback(QObject* parent = nullptr);

  /// Of another run; looks at its newest state.
  void setHistory(std::shared_ptr<const RunHistory> history);
  /// Times the clock of the recording; 0: every snapshot, as fast as they are drawn.
  void setSpeed(double speed);
  /// Goes over this again and again; nullopt: on to the newest.
  void setLoop(std::optional<PlayRange> loop) { loop_ = loop; }
  const std::optional<PlayRange>& loop() const { return loop_; }

  bool atNewest() const { return !index_; }
  bool isPlaying() const { return playing_; }
  /// Observations done where is looked.
  int index() const;
  const RunHistory* history() const { return history_.get(); }

  void seek(int index);  ///< stops playing; the newest, and later ones: toNewest()
  void toNewest();
  void play();
  void pause();
  void stepBack();
  void stepOn();

 Q_SIGNALS:
  /// Of the past, or the newest on the way back to it.
  void shown(const std::shared_ptr<const handmap::Snapshot>& snapshot);
  /// Playing has come to the newest: the run may go on.
  void caughtUp();
  void changed();  ///< whether it plays, and whether it is at the newest

 private:
  void show(int index);
  void advance();
  void startClock();
  void setPlaying(bool playing);
  int next(int index) const;
  double timeOf(int index) const;

  std::shared_ptr<const RunHistory> history_;
  std::optional<int> index_;  ///< of the past; nullopt: the newest
  std::optional<PlayRange> loop_;
  bool playing_ = false;
  double speed_ = 1.0;
  double clock_begin_s_ = 0.0;  ///< of the recording, when clock_ was started
  QElapsedTimer clock_;
  QTimer timer_;
};

}  // namespace handmap
