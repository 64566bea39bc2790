#include "widgets/rig/rig_preview.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/pictures/camera_image.h"

namespace handmap {

namespace {

constexpr double kLeastRange_m = 5.0;

}  // namespace

RigPreviewView::RigPreviewView(QWidget* parent) : QWidget(parent) {
  setObjectName("rig_preview");
  setMinimumSize(200, 120);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void RigPreviewView::show(const RigPreview& preview) {
  if (preview.number == preview_.number) return;
  preview_ = preview;
  words_.clear();
  update();
}

void RigPreviewView::clear(const QString& words) {
  setAccessibleDescription(words);  // it is painted
  preview_ = {};
  words_ = words;
  update();
}

void RigPreviewView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  painter.setPen(palette().text().color());
  if (!words_.isEmpty()) {
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, words_);
  }
  if (!preview_.left.empty()) paintImages(painter);
  if (!preview_.points.empty()) paintPoints(painter);
}

void RigPreviewView::paintImages(QPainter& painter) const {
  const int half = width() / 2;
  int x = 0;
  for (const cv::Mat* image : {&preview_.left, &preview_.right}) {
    if (image->empty()) continue;
    const QSize size =
        QSize(image->cols, image->rows).scaled(half - 2, height(), Qt::KeepAspectRatio);
    painter.drawImage(QRect(QPoint(x, (height() - size.height()) / 2), size), sharedImage(*image));
    x += half;
  }
}

/// From above: forward is up, the robot in the middle.
void RigPreviewView::paintPoints(QPainter& painter) const {
  double range = kLeastRange_m;
  for (const RangePoint& p : preview_.points) {
    range = std::max(range, static_cast<double>(std::hypot(p.x, p.y)));
  }
  const double scale = 0.48 * std::min(width(), height()) / range;
  const QPointF centre(width() / 2.0, height() / 2.0);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().highlight().color(), 2.5));
  for (const RangePoint& p : preview_.points) {
    painter.drawPoint(centre + scale * QPointF(-p.y, -p.x));
  }
  painter.setPen(palette().text().color());
  painter.drawLine(centre, centre - QPointF(0, 10));
  painter.drawEllipse(centre, 4, 4);
  painter.drawText(rect().adjusted(6, 4, -6, -4), Qt::AlignLeft | Qt::AlignBottom,
                   tr("%1 m around").arg(range, 0, 'f', 0));
}

}  // namespace handmap
