#include "app/gui/editing/georeference_actions.h"

#include "core/map/map_limits.h"
#include "core/map/tangent_plane.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/dialogs.h"
#include "widgets/messages/message_bar.h"
#include "widgets/tools/geo_pin_tool.h"

namespace handmap {

namespace {

constexpr double kOffScale = 0.05;  // drawn by eye one is farther off than that
constexpr int kDegreeDecimals = 7;  // a centimetre

}  // namespace

GeoreferenceActions::GeoreferenceActions(const Shell& shell, MapDocument& document,
                                         GeoPinTool& tool, QObject* parent)
    : QObject(parent), shell_(shell), document_(document), tool_(tool) {
  // When the click is over: a dialog keeps its own event loop.
  connect(&tool_, &GeoPinTool::placed, this, &GeoreferenceActions::ask, Qt::QueuedConnection);
  connect(&tool_, &GeoPinTool::complete, this, &GeoreferenceActions::take);
}

void GeoreferenceActions::ask(const Vec2& in_map) {
  const auto& known = document_.map().georeference;
  const Vec2 guess = known ? TangentPlane(*known).longitudeLatitude(in_map) : Vec2(Vec2::Zero());
  const QString degrees = tr("°");
  const QList<double> answer = shell_.dialogs.numbers(
      tr("Where is this place?"),
      {{tr("Latitude"), guess.y(), -kMaxLatitudeDeg, kMaxLatitudeDeg, kDegreeDecimals, degrees},
       {tr("Longitude"), guess.x(), -180.0, 180.0, kDegreeDecimals, degrees}});
  if (answer.size() == 2) tool_.pin({in_map, {answer[1], answer[0]}});
}

void GeoreferenceActions::take(const GeoPin& first, const GeoPin& second) {
  const GeoreferenceFit fit = georeferenceOf(first, second);
  if (std::abs(fit.georeference.latitude) > kMaxLatitudeDeg || !(fit.scale > 0.0)) {
    shell_.messages.show(MessageBar::Kind::Warning,
                         tr("These two places do not say where the drawing lies."));
    return;
  }
  document_.setGeoreference(fit.georeference);
  const QString scale =
      std::abs(fit.scale - 1.0) < kOffScale
          ? QString()
          : tr("On earth the two places are %1 times as far apart as on the drawing.")
                .arg(fit.scale, 0, 'f', 2);
  shell_.messages.show(MessageBar::Kind::Info,
                       tr("The drawing is georeferenced: its origin lies at %1°, %2°.")
                           .arg(fit.georeference.latitude, 0, 'f', 5)
                           .arg(fit.georeference.longitude, 0, 'f', 5),
                       scale);
}

}  // namespace handmap
