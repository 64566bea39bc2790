#include "widgets/teach/teach_view.h"

#include <QMouseEvent>
#include <QPainter>

#include "widgets/style/colours.h"

namespace handmap {

TeachView::TeachView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(240, 180);
  setMouseTracking(true);
  setCursor(Qt::CrossCursor);
}

void TeachView::setImage(const QImage& image, std::vector<WindowLabel> labels) {
  image_ = image;
  grid_ = WindowGrid::of({image.width(), image.height()});
  labels_ = std::move(labels);
  labels_.resize(static_cast<std::size_t>(grid_.count()), WindowLabel::Unknown);
  found_ = cv::Mat1f();
  update();
}

void TeachView::setFound(const cv::Mat1f& probabilities) {
  found_ = probabilities;
  update();
}

QRectF TeachView::imageArea() const {
  const QSizeF size = QSizeF(image_.size()).scaled(this->size(), Qt::KeepAspectRatio);
  return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

QRectF TeachView::areaOf(cv::Rect windows) const {
  const QRectF area = imageArea();
  const double side = kWindow_px * area.width() / image_.width();
  return {area.left() + side * windows.x, area.top() + side * windows.y, side * windows.width,
          side * windows.height};
}

QPointF TeachView::centreOf(int column, int row) const {
  return areaOf({column, row, 1, 1}).center();
}

cv::Rect TeachView::brushAt(QPointF place) const {
  const QRectF area = imageArea();
  if (grid_.count() == 0 || !area.contains(place)) return {};
  const double scale = image_.width() / area.width();
  const cv::Point middle = grid_.at(static_cast<int>((place.x() - area.left()) * scale),
                                    static_cast<int>((place.y() - area.top()) * scale));
  const int half = brush_windows_ / 2;
  return cv::Rect(middle.x - half, middle.y - half, brush_windows_, brush_windows_) &
         cv::Rect(0, 0, grid_.columns, grid_.rows);
}

void TeachView::brush(const QMouseEvent& event) {
  cursor_ = event.position();
  update();
  const bool erases = (event.buttons() & Qt::RightButton) != 0;
  if (!erases && (event.buttons() & Qt::LeftButton) == 0) return;
  const WindowLabel label = erases ? WindowLabel::Unknown : brush_;
  const cv::Rect windows = brushAt(event.position());
  bool changed = false;
  for (int row = windows.y; row < windows.br().y; ++row) {
    for (int column = windows.x; column < windows.br().x; ++column) {
      WindowLabel& old = labels_[static_cast<std::size_t>(row * grid_.columns + column)];
      changed |= old != label;
      old = label;
    }
  }
  if (changed) Q_EMIT labelsChanged();
}

void TeachView::mousePressEvent(QMouseEvent* event) { brush(*event); }
void TeachView::mouseMoveEvent(QMouseEvent* event) { brush(*event); }

void TeachView::leaveEvent(QEvent*) {
  cursor_.reset();
  update();
}

void TeachView::paintLabels(QPainter& painter) const {
  const Colours& colours = Colours::of(palette());
  // What people say is as the truth is shown; what they say is something else is hatched grey.
  QColor building = colours[Role::Truth];
  building.setAlphaF(0.45F);
  QColor other = colours[Role::Odometry];
  other.setAlphaF(0.35F);
  for (int i = 0; i < grid_.count(); ++i) {
    const WindowLabel label = labels_[static_cast<std::size_t>(i)];
    if (label == WindowLabel::Unknown) continue;
    const QRectF area = areaOf({i % grid_.columns, i / grid_.columns, 1, 1});
    if (label == WindowLabel::Building) {
      painter.fillRect(area, building);
    } else {
      painter.fillRect(area, other);
      painter.fillRect(area, QBrush(Qt::white, Qt::BDiagPattern));
    }
  }
}

void TeachView::paintCrosses(QPainter& painter) const {
  if (found_.empty()) return;
  QVector<QLineF> lines;
  for (int row = 0; row < found_.rows; ++row) {
    for (int column = 0; column < found_.cols; ++column) {
      if (found_(row, column) < 0.5F) continue;
      QRectF area = areaOf({column, row, 1, 1});
      const double margin = 0.25 * area.width();
      area.adjust(margin, margin, -margin, -margin);
      lines << QLineF(area.topLeft(), area.bottomRight())
            << QLineF(area.bottomLeft(), area.topRight());
    }
  }
  const Colours& colours = Colours::of(palette());
  painter.setPen(QPen(Qt::white, 3.5, Qt::SolidLine, Qt::RoundCap));
  painter.drawLines(lines);
  painter.setPen(QPen(colours[Role::Corrected], 1.8, Qt::SolidLine, Qt::RoundCap));
  painter.drawLines(lines);
}

void TeachView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (image_.isNull()) {
    painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Open some of your own images, paint where there are buildings and where "
                        "there are none, then train."));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(imageArea(), image_);
  paintLabels(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  paintCrosses(painter);
  if (cursor_) {
    const QRectF area = areaOf(brushAt(*cursor_));
    painter.setPen(QPen(Qt::black, 3.0));
    painter.drawRect(area);
    painter.setPen(QPen(Qt::white, 1.0));
    painter.drawRect(area);
  }
}

}  // namespace handmap
