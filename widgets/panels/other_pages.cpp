#include "widgets/panels/other_pages.h"

#include <QCheckBox>
#include <QLabel>
#include <QLocale>

#include "core/map/map_limits.h"
#include "widgets/panels/sure_box.h"

namespace handmap {

// --- Landmark

LandmarkPage::LandmarkPage(MapDocument& document) : PropertyPage(document, tr("Landmark")) {
  addId();
  name_ = addText("name", tr("Name"), [this](const QString& name) {
    Landmark changed = landmark();
    changed.name = name.toStdString();
    edit(changed, tr("Name Landmark"));
  });
  x_ = addCoordinate("x", tr("x"), [this](double x) {
    Landmark changed = landmark();
    changed.position.x() = x;
    edit(changed, tr("Change x"));
  });
  y_ = addCoordinate("y", tr("y"), [this](double y) {
    Landmark changed = landmark();
    changed.position.y() = y;
    edit(changed, tr("Change y"));
  });
}

Landmark LandmarkPage::landmark() const {
  const MapChange objects = selected(document().map(), {selectedId()});
  return objects.landmarks.empty() ? Landmark{} : objects.landmarks.front();
}

void LandmarkPage::edit(const Landmark& landmark, const QString& text) {
  document().apply({.landmarks = {landmark}}, text, true);
}

void LandmarkPage::refresh() {
  const Landmark shown = landmark();
  showId();
  showText(*name_, QString::fromStdString(shown.name));
  x_->showValue(shown.position.x());
  y_->showValue(shown.position.y());
}

// --- Start

StartPage::StartPage(MapDocument& document) : PropertyPage(document, tr("Start of the robot")) {
  x_ = addCoordinate("x", tr("x"), [this](double x) { edit(&Pose2::x, x); });
  y_ = addCoordinate("y", tr("y"), [this](double y) { edit(&Pose2::y, y); });
  heading_ = addHeading([this](double degrees) { edit(&Pose2::heading, toRadians(degrees)); });
  position_sigma_ =
      addNumber("start_position_sigma", tr("Position ±"), 0.0, kMaxSigma, tr(" m"),
                [this](double sigma) { editUncertainty(&StartUncertainty::position, sigma); });
  position_sigma_->setToolTip(tr("How far the robot may begin from there; 0: exactly there"));
  heading_sigma_ = addNumber(
      "start_heading_sigma", tr("Heading ±"), 0.0, kMaxTurnSigmaDeg, tr("°"),
      [this](double degrees) { editUncertainty(&StartUncertainty::heading, toRadians(degrees)); });
  heading_sigma_->setToolTip(tr("How far it may look to either side of that"));
}

void StartPage::editUncertainty(double StartUncertainty::*member, double value) {
  auto changed = document().map().start_uncertainty.value_or(StartUncertainty{});
  changed.*member = value;
  const bool said = changed != StartUncertainty{};
  document().setStartUncertainty(said ? std::optional(changed) : std::nullopt, true);
}

void StartPage::edit(double Pose2::*member, double value) {
  Pose2 start = document().map().start.value_or(Pose2{});
  start.*member = value;
  document().setStart(start, true);
}

void StartPage::refresh() {
  const std::optional<Pose2>& start = document().map().start;
  if (!start) return;
  x_->showValue(start->x);
  y_->showValue(start->y);
  heading_->showValue(toDegrees(normalizedAngle(start->heading)));
  const auto sure = document().map().start_uncertainty.value_or(StartUncertainty{});
  position_sigma_->showValue(sure.position);
  heading_sigma_->showValue(toDegrees(sure.heading));
}

// --- Map

MapPage::MapPage(MapDocument& document) : PropertyPage(document, tr("Map")) {
  name_ = addText("name", tr("Name"),
                  [this](const QString& name) { this->document().setName(name, true); });
  sure_ = new SureBox;
  addField("sure", tr("Drawn"), sure_);
  connect(sure_, &SureBox::chosen, this,
          [this](const Uncertainty& chosen) { this->document().setUncertainty(chosen); });
  const auto add = [this](const char* name, const QString& label, double Uncertainty::*member) {
    return addNumber(name, label, 0.0, kMaxSigma, tr(" m"), [this, member](double sigma) {
      Uncertainty changed = this->document().map().uncertainty;
      changed.*member = sigma;
      this->document().setUncertainty(changed, true);
    });
  };
  position_sigma_ = add("position_sigma", tr("Position ±"), &Uncertainty::position);
  position_sigma_->setToolTip(tr("How far buildings may lie from where they are drawn"));
  size_sigma_ = add("size_sigma", tr("Size ±"), &Uncertainty::size);
  size_sigma_->setToolTip(tr("How wrong their widths and depths may be"));
  addWholeUncertainty();
  addGeoreference();
  contents_ = new QLabel;
  contents_->setWordWrap(true);
  addField("contents", {}, contents_);
}

void MapPage::addWholeUncertainty() {
  whole_known_ = new QCheckBox(tr("Scale and turn are known"));
  whole_known_->setToolTip(tr("Drawn over an aerial picture or from a public map"));
  addField("whole_known", {}, whole_known_);
  connect(whole_known_, &QCheckBox::clicked, this, [this](bool on) {
    WholeUncertainty changed{{}, {}, document().map().whole.shift};
    if (on) changed.scale = changed.turn = 0.0;
    document().setWholeUncertainty(changed);
  });
  const auto add = [this](const char* name, const QString& label, double most, const QString& unit,
                          std::optional<double> WholeUncertainty::*member, double scale) {
    return addNumber(name, label, 0.0, most, unit, [this, member, scale](double value) {
      WholeUncertainty changed = document().map().whole;
      changed.*member = value * scale;
      document().setWholeUncertainty(changed, true);
    });
  };
  scale_sigma_ = add("scale_sigma", tr("Scale ±"), kPercent * kMaxScaleSigma, tr(" %"),
                     &WholeUncertainty::scale, 1.0 / kPercent);
  scale_sigma_->setToolTip(tr("How much too large or too small all of it may be; 0: to scale"));
  turn_sigma_ = add("turn_sigma", tr("Turn ±"), kMaxTurnSigmaDeg, tr("°"), &WholeUncertainty::turn,
                    toRadians(1.0));
  turn_sigma_->setToolTip(tr("How far all of it may be turned; 0: true"));
  shift_sigma_ =
      add("shift_sigma", tr("Together ±"), kMaxSigma, tr(" m"), &WholeUncertainty::shift, 1.0);
  shift_sigma_->setToolTip(
      tr("How far all buildings may lie off together: a displaced aerial picture"));
}

void MapPage::addGeoreference() {
  georeferenced_ = new QCheckBox(tr("Georeferenced (WGS 84)"));
  addField("georeferenced", {}, georeferenced_);
  connect(georeferenced_, &QCheckBox::clicked, this, [this](bool on) {
    document().setGeoreference(on ? std::optional(Georeference{}) : std::nullopt);
  });
  const auto add = [this](const char* name, const QString& label, double limit, int decimals,
                          double Georeference::*member, double scale) {
    NumberField* field =
        addNumber(name, label, -limit, limit, tr("°"),
                  [this, member, scale](double value) { editGeoreference(member, value * scale); });
    field->setDecimals(decimals);
    return field;
  };
  latitude_ = add("latitude", tr("Latitude"), kMaxLatitudeDeg, 7, &Georeference::latitude, 1.0);
  longitude_ = add("longitude", tr("Longitude"), 180.0, 7, &Georeference::longitude, 1.0);
  east_ = add("x_axis", tr("x axis from east"), 360.0, 3, &Georeference::heading, toRadians(1.0));
}

void MapPage::editGeoreference(double Georeference::*member, double value) {
  Georeference changed = document().map().georeference.value_or(Georeference{});
  changed.*member = value;
  document().setGeoreference(changed, true);
}

void MapPage::refresh() {
  const Map& map = document().map();
  showText(*name_, QString::fromStdString(map.name));
  sure_->showValue(map.uncertainty);
  position_sigma_->showValue(map.uncertainty.position);
  size_sigma_->showValue(map.uncertainty.size);
  const bool known = map.whole.scale || map.whole.turn;
  whole_known_->setChecked(known);
  scale_sigma_->showValue(kPercent * map.whole.scale.value_or(kUsualScaleSigma));
  turn_sigma_->showValue(toDegrees(map.whole.turn.value_or(kUsualTurnSigma)));
  shift_sigma_->showValue(map.shiftSigma());
  for (NumberField* field : {scale_sigma_, turn_sigma_}) field->setEnabled(known);
  shift_sigma_->setEnabled(known || map.whole.shift);
  const Georeference georeference = map.georeference.value_or(Georeference{});
  georeferenced_->setChecked(map.georeference.has_value());
  latitude_->showValue(georeference.latitude);
  longitude_->showValue(georeference.longitude);
  east_->showValue(toDegrees(georeference.heading));
  for (NumberField* field : {latitude_, longitude_, east_})
    field->setEnabled(map.georeference.has_value());
  QString text = tr("Buildings: %1").arg(map.buildings.size());
  if (!map.start) text += tr("\nNo start yet: a run needs to know where the robot begins.");
  if (!map.refinement.empty()) text += tr("\nCorrected by a run.");
  contents_->setText(text);
}

// --- Route, or several kinds

SummaryPage::SummaryPage(MapDocument& document) : PropertyPage(document, tr("Selection")) {
  text_ = new QLabel;
  text_->setWordWrap(true);
  addField("summary", {}, text_);
}

void SummaryPage::refresh() {
  const std::vector<Vec2>& route = document().map().route;
  if (document().selection() != QStringList{kRouteKey}) {
    text_->setText(tr("%1 objects of several kinds").arg(document().selection().size()));
    return;
  }
  double length = 0.0;
  for (std::size_t i = 1; i < route.size(); ++i) length += (route[i] - route[i - 1]).norm();
  text_->setText(tr("Route through %1 points, %2 m long")
                     .arg(route.size())
                     .arg(QLocale::c().toString(length, 'f', 1)));
}

}  // namespace handmap
