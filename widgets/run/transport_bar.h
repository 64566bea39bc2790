// The strip below the canvas: where the observations come from, the actions of a run, its speed and
// how far it is.
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QToolBar;

namespace handmap {

struct FrameReport;

class TransportBar : public QWidget {
  Q_OBJECT
 public:
  explicit TransportBar(QWidget* parent = nullptr);

  QToolBar& toolBar() { return *tool_bar_; }  ///< to be filled with the actions

  double speed() const;         ///< times the clock of the source; 0: as fast as possible
  void setSpeed(double speed);  ///< the nearest there is

  void setSource(const QString& name);
  /// `count` 0: without an end.
  void setProgress(int index, int count, const FrameReport& report);
  void setFinished();  ///< nothing more is to be waited for
  /// A live robot keeps to its own clock.
  void setSpeedEnabled(bool enabled);
  void setShareOfStep(double share);
  void clearProgress();

 Q_SIGNALS:
  void speedChanged(double speed);

 private:
  QLabel* source_;
  QToolBar* tool_bar_;
  QComboBox* speed_;
  QProgressBar* progress_;
  QLabel* frame_;
  int index_ = 0;
};

}  // namespace handmap
