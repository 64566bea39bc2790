#include "widgets/panels/building_page.h"

#include <QCheckBox>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <algorithm>

#include "core/map/map_limits.h"
#include "core/paper/handwriting.h"
#include "widgets/canvas/building_handles.h"
#include "widgets/panels/sure_box.h"
#include "widgets/panels/vertex_table.h"

namespace handmap {

namespace {

/// What `get` gives for all of them; nullopt when they differ.
template <typename Get>
auto common(const std::vector<Building>& buildings, Get get)
    -> std::optional<decltype(get(buildings.front()))> {
  const auto first = get(buildings.front());
  const bool same = std::ranges::all_of(buildings, [&](const auto& b) { return get(b) == first; });
  if (!same) return std::nullopt;
  return first;
}

void showFlag(QCheckBox& box, std::optional<bool> flag) {
  const QSignalBlocker block(box);
  box.setCheckState(!flag ? Qt::PartiallyChecked : *flag ? Qt::Checked : Qt::Unchecked);
}

double degrees(const Rectangle& box) {
  return std::round(toDegrees(normalizedAngle(box.heading)) * 1e9) / 1e9;
}

}  // namespace

BuildingPage::BuildingPage(MapDocument& document) : PropertyPage(document, tr("Building")) {
  addId();
  name_ = addText("name", tr("Name"), [this](const QString& name) {
    edit(tr("Name Building"), [&](Building& building) { building.name = name.toStdString(); });
  });
  writing_ = new QLabel;
  addField("writing", tr("Written"), writing_);
  x_ = addCoordinate("x", tr("x"), [this](double x) {
    editBox(tr("Change x"), [x](Rectangle& box) { box.centre.x() = x; });
  });
  y_ = addCoordinate("y", tr("y"), [this](double y) {
    editBox(tr("Change y"), [y](Rectangle& box) { box.centre.y() = y; });
  });
  width_ = addNumber("width", tr("Width"), kMinSize, kMaxSize, tr(" m"), [this](double width) {
    editBox(tr("Change Width"), [width](Rectangle& box) { box.width = width; });
  });
  depth_ = addNumber("depth", tr("Depth"), kMinSize, kMaxSize, tr(" m"), [this](double depth) {
    editBox(tr("Change Depth"), [depth](Rectangle& box) { box.depth = depth; });
  });
  heading_ = addHeading([this](double heading) {
    editBox(tr("Change Heading"), [heading](Rectangle& box) { box.heading = toRadians(heading); });
  });
  addVertices();
  locked_ = new QCheckBox(tr("Locked against changes by hand"));
  addField("locked", {}, locked_);
  connect(locked_, &QCheckBox::clicked, this, [this] {
    const bool locked = locked_->checkState() != Qt::Unchecked;
    edit(tr("Lock Building"), [locked](Building& building) { building.flags.locked = locked; });
    this->document().finishMerging();
  });
  fixed_ = new QCheckBox(tr("Fixed: a run must not move it"));
  addField("fixed", {}, fixed_);
  connect(fixed_, &QCheckBox::clicked, this, [this] {
    const bool fixed = fixed_->checkState() != Qt::Unchecked;
    edit(tr("Fix Building"), [fixed](Building& building) { building.fixed = fixed; });
    this->document().finishMerging();
  });
  may_not_exist_ = new QCheckBox(tr("May not exist"));
  addField("may_not_exist", {}, may_not_exist_);
  connect(may_not_exist_, &QCheckBox::clicked, this, [this] {
    const bool may = may_not_exist_->checkState() != Qt::Unchecked;
    edit(tr("Doubt Building"), [may](Building& building) { building.may_not_exist = may; });
    this->document().finishMerging();
  });
  addUncertainty();
  estimate_ = new QLabel;
  estimate_->setWordWrap(true);
  addField("estimate", tr("Estimate"), estimate_);
}

void BuildingPage::addUncertainty() {
  own_uncertainty_ = new QCheckBox(tr("Uncertainty of its own"));
  addField("own_uncertainty", {}, own_uncertainty_);
  connect(own_uncertainty_, &QCheckBox::clicked, this, [this] {
    const bool own = own_uncertainty_->checkState() != Qt::Unchecked;
    edit(tr("Change Uncertainty"), [&, own](Building& building) {
      const Uncertainty old = statedOf(building);
      building.uncertainty = own ? std::optional(old) : std::nullopt;
    });
    document().finishMerging();
  });
  sure_ = new SureBox;
  addField("sure", tr("Drawn"), sure_);
  connect(sure_, &SureBox::chosen, this, [this](const Uncertainty& chosen) {
    edit(tr("Change Uncertainty"), [&](Building& building) { building.uncertainty = chosen; });
    document().finishMerging();
  });
  const auto add = [this](const char* name, const QString& label, double Uncertainty::*member) {
    return addNumber(name, label, 0.0, kMaxSigma, tr(" m"), [this, member](double sigma) {
      edit(tr("Change Uncertainty"), [&](Building& building) {
        Uncertainty changed = statedOf(building);
        changed.*member = sigma;
        building.uncertainty = changed;
      });
    });
  };
  position_sigma_ = add("position_sigma", tr("Position ±"), &Uncertainty::position);
  size_sigma_ = add("size_sigma", tr("Size ±"), &Uncertainty::size);
}

void BuildingPage::addVertices() {
  vertices_ = new VertexTable;
  addField("corners", tr("Corners"), vertices_);
  connect(vertices_, &VertexTable::edited, this, [this](const Polygon& polygon) {
    edit(tr("Change Corners"), [&](Building& building) { building.shape = polygon; });
    document().finishMerging();
  });
  connect(vertices_, &VertexTable::refused, this, &PropertyPage::messageRaised);
}

Uncertainty BuildingPage::statedOf(const Building& building) const {
  return building.uncertainty.value_or(document().map().uncertainty);
}

std::vector<Building> BuildingPage::buildings() const {
  return selected(document().map(), document().selection()).buildings;
}

void BuildingPage::edit(const QString& text, const std::function<void(Building&)>& change) {
  std::vector<Building> changed = buildings();
  std::ranges::for_each(changed, change);
  document().apply({.buildings = std::move(changed)}, text, true);
}

void BuildingPage::editBox(const QString& text, const std::function<void(Rectangle&)>& change) {
  edit(text, [&](Building& building) {
    if (isLocked(document().map(), building)) return;
    Rectangle box = building.box();
    change(box);
    building = building.fitted(box);
  });
}

void BuildingPage::refresh() {
  const std::vector<Building> shown = buildings();
  if (shown.empty()) return;
  const bool single = shown.size() == 1;
  findChild<QLabel*>(QStringLiteral("title"))
      ->setText(single ? tr("<b>Building</b>") : tr("<b>%1 Buildings</b>").arg(shown.size()));
  showId();
  const auto name = common(shown, [](const Building& b) { return b.name; });
  name_->setPlaceholderText(name ? QString() : tr("several"));
  showText(*name_, QString::fromStdString(name.value_or("")));

  showField(*writing_, single && shown.front().unknown.contains(kWritingKey));
  if (single) refreshWriting(shown.front());

  const auto box = [&](auto get) {
    return common(shown, [&](const Building& b) { return get(b.box()); });
  };
  x_->showValue(box([](const Rectangle& b) { return b.centre.x(); }));
  y_->showValue(box([](const Rectangle& b) { return b.centre.y(); }));
  width_->showValue(box([](const Rectangle& b) { return b.width; }));
  depth_->showValue(box([](const Rectangle& b) { return b.depth; }));
  heading_->showValue(box(degrees));
  refreshLock(shown);
  showFlag(*fixed_, common(shown, [](const Building& b) { return b.fixed; }));
  showFlag(*may_not_exist_, common(shown, [](const Building& b) { return b.may_not_exist; }));
  const auto* polygon = single ? std::get_if<Polygon>(&shown.front().shape) : nullptr;
  showField(*vertices_, polygon != nullptr);
  if (polygon != nullptr) vertices_->showPolygon(*polygon);
  refreshUncertainty(shown);
  refreshEstimate(shown);
}

/// As somebody wrote it on paper, in the colour of text.
void BuildingPage::refreshWriting(const Building& shown) {
  const cv::Mat ink = writingOf(shown);
  QImage picture;
  if (!ink.empty()) {
    picture = QImage(ink.data, ink.cols, ink.rows, static_cast<qsizetype>(ink.step),
                     QImage::Format_Alpha8)
                  .convertToFormat(QImage::Format_ARGB32_Premultiplied);
    QPainter tint(&picture);
    tint.setCompositionMode(QPainter::CompositionMode_SourceIn);
    tint.fillRect(picture.rect(), palette().color(QPalette::Text));
  }
  writing_->setPixmap(QPixmap::fromImage(picture));
}

/// What is locked is not moved by numbers either.
void BuildingPage::refreshLock(const std::vector<Building>& shown) {
  showFlag(*locked_, common(shown, [](const Building& b) { return b.flags.locked; }));
  const bool free = std::ranges::any_of(
      shown, [&](const Building& building) { return !isLocked(document().map(), building); });
  for (QWidget* field :
       std::initializer_list<QWidget*>{x_, y_, width_, depth_, heading_, vertices_})
    field->setEnabled(free);
}

void BuildingPage::refreshUncertainty(const std::vector<Building>& shown) {
  const auto own = common(shown, [](const Building& b) { return b.uncertainty.has_value(); });
  showFlag(*own_uncertainty_, own);
  const auto sigma = [&](double Uncertainty::*member) {
    return common(shown, [&](const Building& b) { return statedOf(b).*member; });
  };
  sure_->showValue(common(shown, [&](const Building& b) { return statedOf(b); }));
  position_sigma_->showValue(sigma(&Uncertainty::position));
  size_sigma_->showValue(sigma(&Uncertainty::size));
  for (NumberField* field : {position_sigma_, size_sigma_}) field->setEnabled(own.value_or(true));
}

void BuildingPage::refreshEstimate(const std::vector<Building>& shown) {
  if (shown.size() > 1 || !shown.front().estimate) {
    estimate_->setText(shown.size() > 1 ? tr("—") : tr("none yet"));
    return;
  }
  const Estimate& estimate = *shown.front().estimate;
  const auto metres = [](double value) { return QLocale::c().toString(value, 'f', 2); };
  estimate_->setText(
      tr("x ±%1 m, y ±%2 m, width ±%3 m\nObservations: %4")
          .arg(metres(estimate.sigma_x), metres(estimate.sigma_y), metres(estimate.sigma_width))
          .arg(estimate.observations));
}

}  // namespace handmap
