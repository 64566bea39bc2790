// Both images of a stereo camera: with the corners of a board in them, or rectified with lines
// across, on which the same things must lie.
#pragma once

#include <QWidget>

#include "core/calibration/board_capture.h"

namespace handmap {

class BoardPairView : public QWidget {
  Q_OBJECT
 public:
  explicit BoardPairView(QWidget* parent = nullptr);

  void show(std::shared_ptr<const CaptureStatus> status);
  void show(std::shared_ptr<const CapturedCalibration> captured);
  void clear(const QString& words);
  QSize sizeHint() const override { return {560, 240}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintSide(QPainter& painter, int x, const cv::Mat& image,
                 const std::vector<cv::Point2f>& corners) const;
  void paintLines(QPainter& painter) const;

  std::shared_ptr<const CaptureStatus> status_;
  std::shared_ptr<const CapturedCalibration> captured_;
  QString words_;
};

}  // namespace handmap
