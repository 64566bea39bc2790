#include "widgets/calibration/board_view.h"

#include <QPainter>

#include "widgets/pictures/camera_image.h"

namespace handmap {

namespace {

constexpr int kLines = 12;
constexpr double kCorner_px = 3.0;

}  // namespace

BoardPairView::BoardPairView(QWidget* parent) : QWidget(parent) {
  setObjectName("board_view");
  setMinimumSize(320, 140);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void BoardPairView::show(std::shared_ptr<const CaptureStatus> status) {
  if (status == status_) return;
  status_ = std::move(status);
  captured_.reset();
  words_.clear();
  update();
}

void BoardPairView::show(std::shared_ptr<const CapturedCalibration> captured) {
  captured_ = std::move(captured);
  status_.reset();
  words_.clear();
  update();
}

void BoardPairView::clear(const QString& words) {
  status_.reset();
  captured_.reset();
  words_ = words;
  update();
}

void BoardPairView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  painter.setPen(palette().text().color());
  if (!words_.isEmpty()) {
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, words_);
  }
  const int half = width() / 2;
  if (status_) {
    paintSide(painter, 0, status_->left, status_->left_corners);
    paintSide(painter, half, status_->right, status_->right_corners);
  }
  if (captured_) {
    paintSide(painter, 0, captured_->left, {});
    paintSide(painter, half, captured_->right, {});
    paintLines(painter);
  }
}

void BoardPairView::paintSide(QPainter& painter, int x, const cv::Mat& image,
                              const std::vector<cv::Point2f>& corners) const {
  const QSize size =
      QSize(image.cols, image.rows).scaled(width() / 2 - 2, height(), Qt::KeepAspectRatio);
  const QPoint origin(x, (height() - size.height()) / 2);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRect(origin, size), sharedImage(image));
  const double scale = static_cast<double>(size.width()) / image.cols;
  painter.setRenderHint(QPainter::Antialiasing);
  QPolygonF chain;
  for (const cv::Point2f& corner : corners) {
    chain << QPointF(origin) +
                 scale * QPointF(static_cast<double>(corner.x), static_cast<double>(corner.y));
  }
  painter.setPen(QPen(QColor(0, 114, 178), 1.5));  // in the order in which they are numbered
  painter.drawPolyline(chain);
  painter.setPen(QPen(Qt::white, 1.0));
  painter.setBrush(QColor(213, 94, 0));
  for (const QPointF& corner : chain) painter.drawEllipse(corner, kCorner_px, kCorner_px);
}

void BoardPairView::paintLines(QPainter& painter) const {
  painter.setPen(QPen(QColor(213, 94, 0), 1.0));
  for (int i = 1; i <= kLines; ++i) {
    const int y = height() * i / (kLines + 1);
    painter.drawLine(0, y, width(), y);
  }
}

}  // namespace handmap
