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

/// The part of a recording that the next run takes, by its frame numbers.
struct TimelineTrim {
  int first = 0;  ///< of the recording
  int last = 0;
  int from = 0;  ///< of the part
  int to = 0;
  bool operator==(const TimelineTrim&) const = default;
};

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
  /// With handles below the strip; the strip is then as long as the part that the run took which
  /// it shows. nullopt: nothing can be trimmed.
  void setTrim(const std::optional<TimelineTrim>& trim);
  /// A run begins that takes that part.
  void beginTrimmed();

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void seekWanted(int index);
  void loopWanted(std::optional<handmap::PlayRange> loop);
  void trimWanted(int from, int to);

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
  double xOfFrame(int frame) const;
  int frameAt(double x) const;
  /// Where the strip begins and ends.
  std::pair<double, double> ends() const;
  enum class Handle { None, From, To };
  Handle handleAt(const QPointF& at) const;
  void dragHandle(double x);
  void paintHandles(QPainter& painter) const;
  QString textAt(int index) const;
  void toMouse(double x);

  int done_ = 0;
  int count_ = 0;
  double share_ = 0.0;
  std::vector<Mark> marks_;
  std::optional<PlayRange> loop_;
  std::optional<int> loop_begin_;      ///< while it is dragged
  std::optional<TimelineTrim> trim_;   ///< of the next run
  std::optional<TimelineTrim> shown_;  ///< of the run that is shown
  Handle dragged_ = Handle::None;
};

}  // namespace handmap
