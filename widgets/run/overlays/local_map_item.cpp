#include "widgets/run/overlays/local_map_item.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/core.hpp>

namespace handmap {

namespace {

/// Means of so many cells either way: a painter alone would pick one of them, and thin walls would
/// vanish. Cells beyond the last whole mean are left out: half a pixel.
cv::Mat1f shrunk(const cv::Mat1f& cells, int by) {
  if (by == 1) return cells;
  cv::Mat1f means(cells.rows / by, cells.cols / by, 0.0F);
  const float share = 1.0F / static_cast<float>(by * by);
  for (int row = 0; row < means.rows * by; ++row) {
    const float* from = cells[row];
    for (float& mean : cv::Mat1f(means.row(row / by))) {
      for (int i = 0; i < by; ++i) mean += share * *from++;
    }
  }
  return means;
}

/// The surer of a wall, measured by the surest cell, the less transparent.
QImage imageOf(const cv::Mat1f& cells, const QColor& colour) {
  constexpr int kOpaque = 230;
  std::array<QRgb, 256> shades{};
  for (std::size_t i = 0; i < shades.size(); ++i) {
    const int alpha = static_cast<int>(kOpaque * std::sqrt(static_cast<double>(i) / 255.0));
    shades[i] = qPremultiply(qRgba(colour.red(), colour.green(), colour.blue(), alpha));
  }
  double surest = 0.0;
  cv::minMaxLoc(cells, nullptr, &surest);
  const float scale = surest > 0.0 ? static_cast<float>(255.0 / surest) : 0.0F;
  QImage image(cells.cols, cells.rows, QImage::Format_ARGB32_Premultiplied);
  for (int row = 0; row < cells.rows; ++row) {
    const float* from = cells[row];
    auto* to = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < cells.cols; ++column) {
      to[column] = shades[static_cast<std::size_t>(std::clamp(from[column] * scale, 0.0F, 255.0F))];
    }
  }
  return image;
}

}  // namespace

void LocalMapItem::setColours(const Colours& colours) {
  colours_ = &colours;
  image_ = {};
  update();
}

void LocalMapItem::setLocalMap(LazyLocalMap local_map, const Pose2& robot) {
  prepareGeometryChange();
  if (local_map_ != local_map) image_ = {};
  local_map_ = std::move(local_map);
  setPos(robot.x, robot.y);
  setRotation(toDegrees(robot.heading));
}

QRectF LocalMapItem::boundingRect() const {
  if (!local_map_) return {};
  const double half = local_map_.range();
  return {-half, -half, 2.0 * half, 2.0 * half};
}

void LocalMapItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (!local_map_) return;
  const LocalMap& map = local_map_.get();
  const double pixels_a_cell =
      map.cell() * painter->device()->devicePixelRatioF() *
      QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
  const int by =
      static_cast<int>(std::clamp(1.0 / pixels_a_cell, 1.0, static_cast<double>(map.cells().cols)));
  if (image_.isNull() || by != cells_a_pixel_) {
    image_ = imageOf(shrunk(map.cells(), by), (*colours_)[Role::LocalMap]);
    cells_a_pixel_ = by;
  }
  const double side = map.cell() * by * image_.width();
  // Row 0 is the right edge, y = -range: the scene's y axis points up, so the image lies as it is.
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  painter->drawImage(QRectF(-map.range(), -map.range(), side, side), image_);
}

}  // namespace handmap
