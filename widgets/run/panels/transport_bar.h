// The strip below the canvas: the timeline of a run, its actions, its speed and where the
// observations come from.
#pragma once

#include <QWidget>

#include "widgets/background/time_left.h"

class QComboBox;
class QLabel;
class QToolBar;

namespace handmap {

class Timeline;
struct FrameReport;

class TransportBar : public QWidget {
  Q_OBJECT
 public:
  explicit TransportBar(QWidget* parent = nullptr);

  QToolBar& toolBar() { return *tool_bar_; }  ///< to be filled with the actions
  Timeline& timeline() { return *timeline_; }

  double speed() const;         ///< times the clock of the source; 0: as fast as possible
  void setSpeed(double speed);  ///< the nearest there is

  void setSource(const QString& name);
  /// The run has come to `done` of `count` (0: without an end) observations.
  void setExtent(int done, int count);
  /// What is shown: the state after so many observations.
  void setShown(int index, int count, const FrameReport& report);
  /// The same in the middle of an observation.
  void setPhase(int index, int count, const QString& phase);
  /// A live robot keeps to its own clock.
  void setSpeedEnabled(bool enabled);
  /// Of the observation that is worked on, or, before the first, of what opens the source.
  void setShareOfStep(double share);
  void clearProgress();

 Q_SIGNALS:
  void speedChanged(double speed);

 private:
  QLabel* source_;
  QToolBar* tool_bar_;
  QComboBox* speed_;
  Timeline* timeline_;
  QLabel* frame_;
  TimeLeft opening_;
};

}  // namespace handmap
