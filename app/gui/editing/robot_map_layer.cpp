#include "app/gui/editing/robot_map_layer.h"

#include <QFile>
#include <QFileInfo>
#include <cmath>

#include "core/base/error.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

namespace {

const QString kTopic = QStringLiteral("robot map");

}  // namespace

RobotMapLayer::RobotMapLayer(const Shell& shell, MapDocument& document,
                             std::function<void(Underlay)> add, QObject* parent)
    : QObject(parent),
      shell_(shell),
      document_(document),
      add_(std::move(add)),
      self_(std::make_shared<Lifeline<RobotMapLayer>>(*this)) {
  connect(&document_, &MapDocument::mapChanged, this, [this](const Touched& touched) {
    const bool is_other_drawing = touched.listed && touched.route && touched.layers && touched.rest;
    if (!is_other_drawing) return;
    sought_.request_stop();
    shell_.messages.withdraw(kTopic);
  });
}

RobotMapLayer::~RobotMapLayer() {
  self_->cut();
  sought_.request_stop();
}

bool RobotMapLayer::isRobotMap(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return suffix == QLatin1String("yaml") || suffix == QLatin1String("yml");
}

void RobotMapLayer::lay(const QString& path) {
  sought_.request_stop();
  sought_ = std::stop_source();
  const QString name = QFileInfo(path).fileName();
  shell_.messages
      .ask(tr("Where “%1” lies on the drawing is being looked for…").arg(name), {}, kTopic)
      .addAction(tr("Stop"), [stop = sought_]() mutable { stop.request_stop(); });
  startInBackground([self = self_, stop = sought_, name, drawing = document_.map(),
                     file = QFile::encodeName(QFileInfo(path).absoluteFilePath()).toStdString()] {
    try {
      const RobotGrid grid = readRobotGrid(file);
      const auto place = placeOf(grid.ground, drawing, stop.get_token());
      const Underlay map = underlayOf(grid, place ? place->pose : Pose2());
      self->post([stop, name, map, place](RobotMapLayer& layer) {
        if (!stop.stop_requested()) layer.found(name, map, place);
      });
    } catch (const std::exception& error) {
      const auto* known = dynamic_cast<const Error*>(&error);
      self->post([stop, what = std::string(error.what()),
                  hint = known ? known->hint() : std::string()](RobotMapLayer& layer) {
        if (stop.stop_requested()) return;
        layer.shell_.messages.withdraw(kTopic);
        layer.shell_.messages.show(MessageBar::Kind::Error, QString::fromStdString(what),
                                   QString::fromStdString(hint));
      });
    }
  });
}

void RobotMapLayer::found(const QString& name, const Underlay& map,
                          const std::optional<GridPlace>& place) {
  shell_.messages.withdraw(kTopic);
  add_(map);
  if (place) {
    tell(name, *place);
    return;
  }
  shell_.messages.show(
      MessageBar::Kind::Info, tr("“%1” lies as it does in its own frame.").arg(name),
      document_.map().buildings.empty()
          ? tr("No building is drawn on which it could be laid: draw upon it.")
          : tr("There are no straight walls in it by which it could be laid on the drawing."));
}

void RobotMapLayer::tell(const QString& name, const GridPlace& place) {
  const int there = static_cast<int>(std::lround(100.0 * place.supported));
  QStringList hints;
  if (place.fits && place.other) {
    hints << tr("It would lie nearly as well %1 m from there, turned by %2°: look whether it is "
                "the right place.")
                 .arg(std::hypot(place.other->x - place.pose.x, place.other->y - place.pose.y), 0,
                      'f', 0)
                 .arg(std::abs(
                          toDegrees(normalizedAngle(place.other->heading - place.pose.heading))),
                      0, 'f', 0);
  }
  constexpr double kTold = 0.02;
  if (place.fits && std::abs(place.scale - 1.0) > std::max(kTold, 3.0 * place.scale_sigma)) {
    hints << (place.scale > 1.0 ? tr("What is drawn is %1 % larger than what the robot has.")
                                : tr("What is drawn is %1 % smaller than what the robot has."))
                 .arg(100.0 * std::abs(place.scale - 1.0), 0, 'f', 0);
  }
  if (!place.fits) {
    hints << tr("Of the walls that faced what it saw, only %1 % are there: it may be of another "
                "place.")
                 .arg(there);
  }
  const QString text =
      place.fits ? tr("“%1” lies on the drawing: of the walls that faced what it saw, %2 % are "
                      "there, half of them within %3 m and nine of ten within %4 m.")
                       .arg(name)
                       .arg(there)
                       .arg(place.median_m, 0, 'f', 1)
                       .arg(place.most_m, 0, 'f', 1)
                 : tr("“%1” does not fit the drawing.").arg(name);
  const bool doubtful = !place.fits || place.other;
  shell_.messages.show(doubtful ? MessageBar::Kind::Warning : MessageBar::Kind::Info, text,
                       hints.join(QLatin1Char(' ')));
}

}  // namespace handmap
