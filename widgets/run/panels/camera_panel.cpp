#include "widgets/run/panels/camera_panel.h"

#include <QPainter>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/classification/overlay.h"
#include "widgets/pictures/camera_image.h"
#include "widgets/style/colours.h"

namespace handmap {

namespace {

constexpr double kJudgedBuilding = 0.5;  // probability of a window that has a cross

}  // namespace

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
  setAccessibleName(snapshot_ ? tr("Camera: %1").arg(caption()) : tr("Camera"));
  update();
}

void CameraPanel::setWitnesses(const std::vector<cv::Rect>& windows) {
  if (windows == witnesses_) return;
  witnesses_ = windows;
  setAccessibleName(snapshot_ ? tr("Camera: %1").arg(caption()) : tr("Camera"));
  update();
}

QString CameraPanel::caption() const {
  if (!snapshot_) return {};
  QString text =
      tr("Frame %1 · %2 s").arg(snapshot_->pictured).arg(snapshot_->report.time_s, 0, 'f', 1);
  if (snapshot_->pictured != snapshot_->report.frame) {
    text = tr("Frame %1, the last that is kept before frame %2")
               .arg(snapshot_->pictured)
               .arg(snapshot_->report.frame);
  }
  const Panning& panning = snapshot_->panning;
  if (panning.views > 1 || panning.pan != 0.0) {
    text += tr(" · looks %1° (%2 of %3)")
                .arg(std::lround(toDegrees(panning.pan)))
                .arg(panning.view)
                .arg(panning.views);
  }
  if (!witnesses_.empty()) {
    text += tr(" · %n window(s) placed the wall", nullptr, static_cast<int>(witnesses_.size()));
  }
  const cv::Mat1f& windows = snapshot_->buildings;
  if (windows.empty()) return text;
  const int buildings = cv::countNonZero(windows > kJudgedBuilding);
  return text + tr(" · %1 % building").arg(100 * buildings / static_cast<int>(windows.total()));
}

void CameraPanel::paintWitnesses(QPainter& painter, const QRect& area) const {
  const double scale = static_cast<double>(area.width()) / image_.width();
  const Colours& colours = Colours::of(palette());
  painter.setPen(QPen(colours[Role::Selection], 1.5));
  painter.setBrush(colours.brush(Role::Selection));
  for (const cv::Rect& window : witnesses_) {
    painter.drawRect(QRectF(area.x() + scale * window.x, area.y() + scale * window.y,
                            scale * window.width, scale * window.height));
  }
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
  const int line = fontMetrics().height() + kGap;
  painter.drawText(QRect(kGap, 0, width() - 2 * kGap, line), Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(caption(), Qt::ElideRight, width() - 2 * kGap));
  const QSize half(width(), (height() - line - kGap) / 2);
  int top = line;
  for (const QImage* shown : {&image_, &disparity_}) {
    const QImage& image = *shown;
    if (image.isNull()) continue;
    const QSize size = image.size().scaled(half, Qt::KeepAspectRatio);
    const QRect area(QPoint((width() - size.width()) / 2, top), size);
    painter.drawImage(area, image);
    if (&image == &image_) paintWitnesses(painter, area);
    top += size.height() + kGap;
  }
}

}  // namespace handmap
