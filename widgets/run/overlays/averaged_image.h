// Images of many small cells on a canvas that may be zoomed out far.
#pragma once

#include <QImage>
#include <QRectF>

class QPainter;

namespace handmap {

/// `image` for painting over `area` (scene metres): where several of its cells fall on a pixel,
/// shrunk to their means. A painter alone would pick one of them, and thin walls would vanish.
QImage averagedFor(const QPainter& painter, const QRectF& area, const QImage& image);

}  // namespace handmap
