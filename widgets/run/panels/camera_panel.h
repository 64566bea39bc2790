// What the robot's camera sees: the left image and its disparities, near warm and far cold.
#pragma once

#include <QImage>
#include <QWidget>

#include "core/method/snapshot.h"

namespace handmap {

/// The same with a cross on every window judged to show a building.
QImage judgedImage(const cv::Mat& image, const cv::Mat1f& buildings);
/// Unknown disparities are black.
QImage disparityImage(const cv::Mat1f& disparity);

class CameraPanel : public QWidget {
  Q_OBJECT
 public:
  explicit CameraPanel(QWidget* parent = nullptr);

  /// nullptr shows that there is nothing yet.
  void setSnapshot(std::shared_ptr<const Snapshot> snapshot);
  const Snapshot* snapshot() const { return snapshot_.get(); }
  /// Pixels of the left image that placed the wall that is asked about.
  void setWitnesses(const std::vector<cv::Rect>& windows);
  /// Which frame it is, when, and how much of the image is judged to be buildings.
  QString caption() const;

  QSize sizeHint() const override { return {320, 220}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintWitnesses(QPainter& painter, const QRect& area) const;

  std::shared_ptr<const Snapshot> snapshot_;
  std::shared_ptr<const Snapshot> converted_;  ///< what the images are of: made when painted
  std::vector<cv::Rect> witnesses_;
  QImage image_;
  QImage disparity_;
};

}  // namespace handmap
