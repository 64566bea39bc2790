// Occupancy grids of other programs under the drawing, laid where they are found to lie on it.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "app/gui/shell/shell.h"
#include "core/geodata/robot_map.h"
#include "core/map_match/grid_place.h"
#include "widgets/background/background.h"

namespace handmap {

class MapDocument;

class RobotMapLayer : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it. `add` gets the picture, its path absolute.
  RobotMapLayer(const Shell& shell, MapDocument& document, std::function<void(Underlay)> add,
                QObject* parent);
  ~RobotMapLayer() override;

  /// Whether the name is that of the text of map_server.
  static bool isRobotMap(const QString& path);
  /// Sought in the background; one that is still sought is let go, as when another drawing is
  /// opened meanwhile.
  void lay(const QString& path);

 private:
  void found(const QString& name, const Underlay& map, const std::optional<GridPlace>& place);
  void tell(const QString& name, const GridPlace& place);

  const Shell& shell_;
  MapDocument& document_;
  std::function<void(Underlay)> add_;
  std::shared_ptr<Lifeline<RobotMapLayer>> self_;
  std::stop_source sought_;
};

}  // namespace handmap
