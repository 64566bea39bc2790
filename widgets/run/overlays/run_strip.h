// The line on the canvas that says where the robot is and how sure, and whether the view follows
// it. Seen without opening anything.
#pragma once

#include <QFrame>

#include "core/method/snapshot.h"
#include "widgets/run/overlays/follow_robot.h"

class QLabel;
class QToolButton;

namespace handmap {

class RunStrip : public QFrame {
  Q_OBJECT
 public:
  /// Stands in the upper left corner of `over`.
  explicit RunStrip(QWidget& over);

  /// `map`: as it is shown; to say what the robot is beside.
  void show(const FrameReport& report, const Map& map);
  /// What an observation has come to in between, below; empty: nothing.
  void showPhase(const QString& text);
  void showNothing();
  void setMode(FollowRobot::Mode mode);
  QString words() const;

 Q_SIGNALS:
  void followRequested();  ///< the next mode

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void place();
  void applyPalette();

  QLabel* certainty_;
  QLabel* place_;
  QToolButton* follow_;
  QLabel* phase_;
};

}  // namespace handmap
