// The metric grid and the scale bar.
#pragma once

#include <QPainter>

#include "widgets/style/colours.h"

namespace handmap {

/// The least of 1, 2, 5 × 10ⁿ metres that is at least `metres`.
double roundedStep(double metres);

/// Lines of one and of ten steps, as far apart as the eye can follow, with the metres along the top
/// and the left edge. The painter is in device pixels, `area` is what it shows.
void paintGrid(QPainter& painter, const QTransform& to_device, const QRectF& area,
               const Colours& colours);
void paintScaleBar(QPainter& painter, double pixels_per_metre, const QRectF& area,
                   const Colours& colours);

}  // namespace handmap
