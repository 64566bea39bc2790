// Where the drawing lies on earth, by places that somebody clicks and knows the coordinates of.
#pragma once

#include <QObject>

#include "app/gui/shell/shell.h"
#include "core/map/georeference_fit.h"

namespace handmap {

class GeoPinTool;
class MapDocument;

class GeoreferenceActions : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  GeoreferenceActions(const Shell& shell, MapDocument& document, GeoPinTool& tool, QObject* parent);

 private:
  void ask(const Vec2& in_map);
  void take(const GeoPin& first, const GeoPin& second);

  const Shell& shell_;
  MapDocument& document_;
  GeoPinTool& tool_;
};

}  // namespace handmap
