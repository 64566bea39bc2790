// The plan on a sheet: a title, what the canvas shows with its scale, and a legend.
#pragma once

#include <QList>
#include <QPixmap>
#include <QString>

namespace handmap {

class MapCanvas;

struct PlanSheet {
  QString title;
  QList<std::pair<QPixmap, QString>> legend;  ///< sample and name of what is shown
};

/// As PNG, SVG or PDF, as the path ends. Throws Error.
void writePlan(MapCanvas& canvas, const PlanSheet& sheet, const QString& path);

}  // namespace handmap
