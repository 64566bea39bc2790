// The time of a run as a strip: how far it has come, where one looks, what happened when. A slider,
// for the keyboard and for screen readers: its value is the number of observations done.
#pragma once

#include <QAbstractSlider>
#include <optional>
#include <set>
#include <vector>

#include "widgets/run/worker/playback.h"

namespace handmap {

/// What is marked on it.
enum class TimelineMark { Skipped, Gap, Guessed, Given, Bookmark };

class Timeline : public QAbstractSlider {
  Q_OBJECT
 public:
  explicit Timeline(QWidget* parent = nullptr);

  /// A run that has come to `done` of `count` observations; 0: without end.
  void setExtent(int done, int count);
  /// How far the observation that is worked on is.
  void setShareOfStep(double share);
  /// Where is looked; the newest where it is the last one done.
  void setIndex(int index);
  void clear();

  int done() const { return done_; }
  void addMark(int index, TimelineMark mark, const QString& text);
  void removeMarks(TimelineMark mark);
  void toggleBookmark(int index);
  /// The next bookmark after where is looked, around the end; nullopt: there is none.
  std::optional<int> nextBookmark() const;
  /// Drawn as a band; chosen by dragging with Shift.
  void setLoop(std::optional<PlayRange> loop);
  const std::optional<PlayRange>& loop() const { return loop_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void seekWanted(int index);
  void loopWanted(std::optional<handmap::PlayRange> loop);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Mark {
    int index;
    TimelineMark mark;
    QString text;
  };

  int count() const { return count_ > 0 ? count_ : done_; }
  double xOf(double index) const;
  int indexAt(double x) const;
  QString textAt(int index) const;
  void toMouse(double x);

  int done_ = 0;
  int count_ = 0;
  double share_ = 0.0;
  std::vector<Mark> marks_;
  std::optional<PlayRange> loop_;
  std::optional<int> loop_begin_;  ///< while it is dragged
};

}  // namespace handmap
