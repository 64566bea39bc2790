// A part of the canvas as it was painted last: taken again while neither the view nor what it shows
// has changed.
#pragma once

#include <QFont>
#include <QPaintEngine>
#include <QPainter>
#include <QPixmap>
#include <QTransform>

namespace handmap {

class StillPicture {
 public:
  void forget() { pixmap_ = {}; }

  /// `painter` and `area` are in device coordinates. `paint` is given a painter of the same
  /// coordinates where there is no picture yet of this view.
  template <typename Paint>
  void show(QPainter& painter, const QTransform& to_device, const QRect& area, Paint paint) {
    if (painter.paintEngine()->type() != QPaintEngine::Raster) return paint(painter);  // on paper
    const double ratio = painter.device()->devicePixelRatioF();
    if (pixmap_.isNull() || to_device_ != to_device || area_ != area || font_ != painter.font() ||
        pixmap_.devicePixelRatio() != ratio) {
      pixmap_ = QPixmap((QSizeF(area.size()) * ratio).toSize().expandedTo({1, 1}));
      pixmap_.setDevicePixelRatio(ratio);
      pixmap_.fill(Qt::transparent);
      to_device_ = to_device;
      area_ = area;
      font_ = painter.font();
      QPainter on_picture(&pixmap_);
      on_picture.setFont(font_);
      on_picture.translate(-area.topLeft());
      paint(on_picture);
    }
    painter.drawPixmap(area.topLeft(), pixmap_);
  }

 private:
  QPixmap pixmap_;
  QTransform to_device_;
  QRect area_;
  QFont font_;
};

}  // namespace handmap
