// One image, zoomed to fit, whose windows are painted as building or not.
#pragma once

#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/classification/window_labels.h"
#include "core/classification/windows.h"

namespace handmap {

class TeachView : public QWidget {
  Q_OBJECT
 public:
  explicit TeachView(QWidget* parent = nullptr);

  /// `labels`: one a whole window of the image. A null image shows a hint in its place.
  void setImage(const QImage& image, std::vector<WindowLabel> labels);
  /// What a classifier has found in this image, rows × columns of windows: crosses from 0.5 on.
  /// Empty: no crosses.
  void setFound(const cv::Mat1f& probabilities);
  /// What the left button paints; the right one erases.
  void setBrush(WindowLabel label) { brush_ = label; }
  /// 1 is one window, 3 is 3×3 …
  void setBrushWindows(int side) { brush_windows_ = side; }

  const std::vector<WindowLabel>& labels() const { return labels_; }
  /// Where the middle of a window is in this widget.
  QPointF centreOf(int column, int row) const;

  QSize sizeHint() const override { return {480, 360}; }

 Q_SIGNALS:
  void labelsChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  QRectF imageArea() const;
  QRectF areaOf(cv::Rect windows) const;
  cv::Rect brushAt(QPointF place) const;  ///< windows; empty outside of the image
  void paintLabels(QPainter& painter) const;
  void paintCrosses(QPainter& painter) const;
  void brush(const QMouseEvent& event);

  QImage image_;
  WindowGrid grid_;
  std::vector<WindowLabel> labels_;
  cv::Mat1f found_;
  WindowLabel brush_ = WindowLabel::Building;
  int brush_windows_ = 3;
  std::optional<QPointF> cursor_;
};

}  // namespace handmap
