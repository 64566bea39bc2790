// Tells of the corrected building under the mouse: what was found, and what speaks for and against
// it. And of the wall that is clicked.
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "core/geometry/polygon.h"

namespace handmap {

class MapCanvas;
class RunOverlays;

class BuildingHints : public QObject {
  Q_OBJECT
 public:
  BuildingHints(MapCanvas& canvas, const RunOverlays& overlays, QObject* parent = nullptr);

  /// The id of the corrected building that is shown there; empty: none.
  QString buildingAt(const Vec2& metres) const;

 Q_SIGNALS:
  /// With the tool that selects; the tool hears of the click too. Indices of the building and of a
  /// wall of its footprint.
  void wallClicked(std::size_t building, std::size_t wall);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void click(QPointF viewport_position);
  std::optional<std::size_t> indexAt(const Vec2& metres) const;
  /// Empty: no building there.
  QString wordsAt(QPointF viewport_position) const;

  MapCanvas& canvas_;
  const RunOverlays& overlays_;
};

}  // namespace handmap
