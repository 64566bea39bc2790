// What the sensors of a rig see at this moment: both images, or the returns from above.
#pragma once

#include <QWidget>

#include "core/rig/rig_monitor.h"

namespace handmap {

class RigPreviewView : public QWidget {
  Q_OBJECT
 public:
  explicit RigPreviewView(QWidget* parent = nullptr);

  void show(const RigPreview& preview);
  void clear(const QString& words);
  QSize sizeHint() const override { return {320, 180}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintImages(QPainter& painter) const;
  void paintPoints(QPainter& painter) const;

  RigPreview preview_;
  QString words_;
};

}  // namespace handmap
