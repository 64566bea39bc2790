#include "widgets/run/camera_panel.h"

#include <QPainter>

#include <opencv2/imgproc.hpp>

#include "core/classification/overlay.h"

namespace handmap {

QImage cameraImage(const cv::Mat& image) {
  if (image.empty() || image.depth() != CV_8U) return {};
  const auto wrapped = [&image](QImage::Format format) {
    return QImage(image.data, image.cols, image.rows, static_cast<qsizetype>(image.step), format)
        .copy();
  };
  if (image.channels() == 1) return wrapped(QImage::Format_Grayscale8);
  if (image.channels() == 3) return wrapped(QImage::Format_BGR888);
  return {};
}

QImage judgedImage(const cv::Mat& image, const cv::Mat1f& buildings) {
  if (image.empty() || buildings.empty()) return cameraImage(image);
  return cameraImage(withCrosses(image, buildings));
}

QImage disparityImage(const cv::Mat1f& disparity) {
  if (disparity.empty()) return {};
  double greatest = 0.0;
  cv::minMaxLoc(disparity, nullptr, &greatest);
  if (!(greatest > 0.0)) greatest = 1.0;
  cv::Mat scaled;
  cv::Mat coloured;
  disparity.convertTo(scaled, CV_8U, 255.0 / greatest);
  cv::applyColorMap(scaled, coloured, cv::COLORMAP_TURBO);
  coloured.setTo(cv::Scalar::all(0), disparity < 0.0F);
  return cameraImage(coloured);
}

CameraPanel::CameraPanel(QWidget* parent) : QWidget(parent) { setMinimumSize(160, 120); }

void CameraPanel::setSnapshot(std::shared_ptr<const Snapshot> snapshot) {
  snapshot_ = std::move(snapshot);
  update();
}

void CameraPanel::paintEvent(QPaintEvent*) {
  if (converted_ != snapshot_) {
    converted_ = snapshot_;
    image_ = snapshot_ ? judgedImage(snapshot_->image, snapshot_->buildings) : QImage();
    disparity_ = snapshot_ ? disparityImage(snapshot_->disparity) : QImage();
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (image_.isNull()) {
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No camera image yet"));
    return;
  }
  constexpr int kGap = 4;
  const QSize half(width(), (height() - kGap) / 2);
  int top = 0;
  for (const QImage& image : {image_, disparity_}) {
    if (image.isNull()) continue;
    const QSize size = image.size().scaled(half, Qt::KeepAspectRatio);
    painter.drawImage(QRect(QPoint((width() - size.width()) / 2, top), size), image);
    top += size.height() + kGap;
  }
}

}  // namespace handmap
