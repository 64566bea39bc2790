#include "widgets/tools/toolbox.h"

#include "widgets/canvas/hit_test.h"
#include "widgets/tools/corner_handles.h"
#include "widgets/tools/edge_rectangle_tool.h"
#include "widgets/tools/eraser_tool.h"
#include "widgets/tools/freehand_tool.h"
#include "widgets/tools/geo_pin_tool.h"
#include "widgets/tools/landmark_tool.h"
#include "widgets/tools/measure_tool.h"
#include "widgets/tools/paper_tool.h"
#include "widgets/tools/picture_tool.h"
#include "widgets/tools/polygon_tool.h"
#include "widgets/tools/rectangle_tool.h"
#include "widgets/tools/robot_pose_tool.h"
#include "widgets/tools/route_tool.h"
#include "widgets/tools/select_tool.h"
#include "widgets/tools/start_tool.h"

namespace handmap {

template <typename ToolType, typename... Arguments>
ToolType* Toolbox::add(Arguments&&... arguments) {
  auto tool = std::make_unique<ToolType>(document_, std::forward<Arguments>(arguments)...);
  ToolType* added = tool.get();
  canvas_.addTool(std::move(tool));
  return added;
}

Toolbox::Toolbox(MapDocument& document, MapCanvas& canvas, QObject* parent)
    : QObject(parent), document_(document), canvas_(canvas), select_(add<SelectTool>()) {
  add<RectangleTool>();
  add<EdgeRectangleTool>();
  add<PolygonTool>();
  freehand_ = add<FreehandTool>();
  add<StartTool>();
  add<RouteTool>();
  add<LandmarkTool>();
  add<MeasureTool>();
  add<EraserTool>();
  picture_ = add<PictureTool>([&canvas](std::size_t place) { return canvas.pictureSize(place); });
  geo_pin_ = add<GeoPinTool>();
  paper_ = add<PaperTool>();
  const auto* robot_pose = add<RobotPoseTool>();
  connect(robot_pose, &RobotPoseTool::given, this, [this](const Pose2& pose) {
    canvas_.setTool(ToolId::Select);
    Q_EMIT robotPoseGiven(pose);
  });
  connect(select_, &SelectTool::renameRequested, &canvas_, [this](const QString& key) {
    document_.setSelection({key});
    canvas_.renameSelected();
  });
}

void Toolbox::setRecognizing(bool on) { freehand_->setRecognizing(on); }

bool Toolbox::canAddCorner() const {
  const Building* building = onlyBuilding(document_);
  return (building && !building->flags.locked) ||
         (document_.selection() == QStringList{kRouteKey} && document_.map().route.size() > 1);
}

void Toolbox::addCorner() {
  if (!canAddCorner()) return;
  canvas_.setTool(ToolId::Select);
  constexpr double kReachPx = 12.0;
  const auto at = canvas_.takeMenuPlace();
  if (at && select_->addCornerAt(*at, kReachPx / canvas_.pixelsPerMetre())) return;
  if (select_->addCornerBehindChosen()) return;
  // Otherwise in the middle of the longest wall.
  const Building* building = onlyBuilding(document_);
  const CornerLine line =
      building ? CornerLine{building->footprint(), true} : CornerLine{document_.map().route, false};
  std::size_t longest = 0;
  const auto length = [&](std::size_t edge) {
    return (line.corners[(edge + 1) % line.corners.size()] - line.corners[edge]).norm();
  };
  for (std::size_t i = 1; i < line.edgeCount(); ++i)
    if (length(i) > length(longest)) longest = i;
  select_->addCornerAt(positionOf(line, {longest, true}), 0.01);
}

}  // namespace handmap
