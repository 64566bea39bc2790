#include "app/gui/editing/picture_actions.h"

#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>

#include "app/gui/editing/robot_map_layer.h"
#include "app/gui/files/reference_trust.h"
#include "app/gui/shell/docks.h"
#include "core/base/error.h"
#include "core/map/map_limits.h"
#include "core/map/references.h"
#include "widgets/actions/action_set.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/messages/dialogs.h"
#include "widgets/messages/message_bar.h"
#include "widgets/panels/property_panel.h"
#include "widgets/pictures/picture_file.h"
#include "widgets/tools/picture_tool.h"

namespace handmap {

namespace {

constexpr auto kFolderKey = "pictures/folder";
constexpr auto kPictureActionsTopic = "picture";
constexpr double kShareOfCanvas = 0.8;
constexpr double kUsualOpacity = 0.6;

std::filesystem::path native(const QString& path) { return QFile::encodeName(path).toStdString(); }

/// As large as it shows whole, about the middle.
Underlay spread(Underlay underlay, const QSize& size, const QRectF& visible, const Vec2& middle) {
  underlay.metres_per_pixel = std::min(
      kMaxMetresPerPixel,
      kShareOfCanvas * std::min(visible.width() / size.width(), visible.height() / size.height()));
  underlay.x = middle.x() - 0.5 * size.width() * underlay.metres_per_pixel;
  underlay.y = middle.y() + 0.5 * size.height() * underlay.metres_per_pixel;
  return underlay;
}

}  // namespace

PictureActions::PictureActions(const Shell& shell, MapDocument& document, MapCanvas& canvas,
                               PictureTool& tool, PropertyPanel& properties, ReferenceTrust& trust,
                               QObject* parent)
    : QObject(parent),
      shell_(shell),
      document_(document),
      canvas_(canvas),
      tool_(tool),
      properties_(properties),
      trust_(trust),
      robot_maps_(new RobotMapLayer(
          shell, document, [this](Underlay map) { canvas_.zoomToObject(layUnder(map, {})); },
          this)) {
  shell_.actions.on("draw.add_picture", this, [this] { ask(); });
  properties_.setPictureTool(tool_);
  connect(&properties_, &PropertyPanel::pictureToolRequested, &canvas_,
          [this] { canvas_.setTool(ToolId::Picture); });
}

void PictureActions::ask() {
  const QString path = shell_.dialogs.fileToOpen({tr("Add a picture underneath"),
                                                  shell_.settings.value(kFolderKey).toString(),
                                                  filter(),
                                                  {},
                                                  {}});
  if (path.isEmpty()) return;
  shell_.settings.setValue(kFolderKey, QFileInfo(path).path());
  add(path);
}

QString PictureActions::filter() {
  return tr("Pictures and maps of robots (%1 %2)")
             .arg(pictureEndings(), QStringLiteral("*.yaml *.yml")) +
         QStringLiteral(";;") + pictureFilter() + QStringLiteral(";;") +
         tr("Maps of robots, map_server (%1)").arg(QStringLiteral("*.yaml *.yml"));
}

void PictureActions::add(const QString& path, std::optional<QPointF> middle) {
  const Map& map = document_.map();
  if (map.underlays.size() >= kMaxUnderlays) {
    shell_.messages.show(MessageBar::Kind::Warning,
                         tr("There are %1 pictures, and no room for more.").arg(kMaxUnderlays));
    return;
  }
  if (RobotMapLayer::isRobotMap(path)) {
    robot_maps_->lay(path);
    return;
  }
  PictureHead head;
  try {
    head = readPictureHead(path);
  } catch (const Error& error) {
    shell_.messages.show(MessageBar::Kind::Error, QString::fromUtf8(error.what()),
                         QString::fromStdString(error.hint()), kPictureActionsTopic);
    return;
  }
  const QRectF visible = canvas_.visibleMetres();
  const QPointF centre = middle.value_or(visible.center());
  Underlay underlay;
  underlay.opacity = kUsualOpacity;
  underlay.image = native(QFileInfo(path).absoluteFilePath()).string();
  underlay = spread(underlay, head.size, visible, {centre.x(), centre.y()});

  const auto placed =
      head.geometry ? grounded(underlay, *head.geometry, map.georeference, {centre.x(), centre.y()})
                    : std::nullopt;
  if (placed) underlay = placed->fit.underlay;
  const QString key = layUnder(underlay, placed ? placed->georeference : std::nullopt);

  const QString name = QFileInfo(path).fileName();
  if (placed) {
    canvas_.zoomToObject(key);
    QString hint = placed->georeference ? tr("The map has taken over where on Earth it lies.")
                                        : tr("What is drawn already may have to be moved over it.");
    if (placed->fit.residual > underlay.metres_per_pixel)
      hint = tr("Its pixels are not square: it is off by up to %1 m.")
                 .arg(placed->fit.residual, 0, 'f', 1);
    shell_.messages.show(MessageBar::Kind::Info, tr("“%1” lies where its file says.").arg(name),
                         hint, kPictureActionsTopic);
    return;
  }
  const QString hint = head.geometry
                           ? tr("It lies too far from where the map is; drag it to its place.")
                           : tr("Drag it to its place. Its scale is a guess:");
  shell_.messages.show(MessageBar::Kind::Info, tr("“%1” lies under the drawing.").arg(name), hint,
                       kPictureActionsTopic);
  shell_.messages.addAction(tr("Scale by a length"),
                            [this] { adjust(static_cast<int>(PictureTool::Mode::Scale)); });
  shell_.messages.addAction(tr("Fit by points"),
                            [this] { adjust(static_cast<int>(PictureTool::Mode::Fit)); });
}

QString PictureActions::layUnder(Underlay underlay,
                                 const std::optional<Georeference>& georeference) {
  const QString origin = document_.origin();
  if (!origin.isEmpty()) underlay.image = referenceFrom(native(origin), underlay.image);
  const bool was_trusted = trust_.allows();
  const QString key = document_.addUnderlay(std::move(underlay), georeference);
  if (was_trusted) document_.setTrustsReferences(true);  // this one was chosen by hand
  document_.setSelection({key});
  canvas_.setTool(ToolId::Picture);
  shell_.docks.show(properties_);
  canvas_.setFocus();
  return key;
}

void PictureActions::adjust(int mode) {
  canvas_.setTool(ToolId::Picture);
  tool_.setMode(static_cast<PictureTool::Mode>(mode));
  canvas_.setFocus();
}

}  // namespace handmap
