#include "widgets/run/panels/layers_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSettings>
#include <QSlider>
#include <QVBoxLayout>

#include "widgets/run/overlays/corrected_map_item.h"
#include "widgets/run/overlays/seen_item.h"

namespace handmap {

namespace {

constexpr QSize kSample(34, 16);
constexpr int kSliderWidth = 48;
constexpr int kBesideBox = 20;     // where the samples of the layers begin
constexpr int kLeastPercent = 10;  // fainter is what the switch is for

/// The ground is not drawn fainter, and pictures have their own opacity each.
bool hasOpacity(Layer layer) { return layer != Layer::Grid && layer != Layer::Underlays; }

void paintArrow(QPainter& painter, const QRectF& area) {
  const QPointF tip(area.right(), area.center().y());
  painter.drawLine(QPointF(area.left(), tip.y()), tip);
  painter.drawLine(tip, tip + QPointF(-6.0, -3.5));
  painter.drawLine(tip, tip + QPointF(-6.0, 3.5));
}

void paintSample(QPainter& painter, const LayerSpec& spec, const Colours& colours) {
  const QRectF area = QRectF(QPointF(), kSample).adjusted(2.0, 3.0, -2.0, -3.0);
  const Role role = spec.role;
  switch (spec.layer) {
    case Layer::Band:
      painter.fillRect(area, colours.brush(role));
      return;
    case Layer::LocalMap:
      painter.fillRect(area, colours[role]);
      return;
    case Layer::Changes:
      painter.setPen(QPen(colours[role], 1.6));
      paintArrow(painter, area);
      return;
    case Layer::PoseSpread:
      painter.setPen(QPen(colours[role], 1.2));
      painter.drawEllipse(area.adjusted(5.0, 0.0, -5.0, 0.0));
      return;
    case Layer::Rays:
      painter.setPen(QPen(colours[role], 1.0));
      for (const double y : {0.0, 0.5, 1.0}) {
        painter.drawLine(QPointF(area.left(), area.center().y()),
                         QPointF(area.right(), area.top() + y * area.height()));
      }
      return;
    case Layer::Points:
      painter.setPen(QPen(colours[role], 2.5, Qt::SolidLine, Qt::RoundCap));
      for (const double x : {0.15, 0.4, 0.6, 0.85}) {
        painter.drawPoint(QPointF(area.left() + x * area.width(), area.center().y()));
      }
      return;
    case Layer::SeenWalls:
      painter.setPen(QPen(colours[Role::Corrected], 1.6));
      painter.drawLine(QPointF(area.left(), area.center().y()),
                       QPointF(area.right(), area.center().y()));
      painter.setPen(SeenItem::wallPen(colours));
      painter.drawLine(QPointF(area.left() + 8.0, area.center().y()),
                       QPointF(area.right() - 8.0, area.center().y()));
      return;
    case Layer::Sight:
      painter.setPen(SeenItem::rangePen(colours));
      painter.setBrush(SeenItem::sightBrush(colours));
      painter.drawEllipse(area.adjusted(5.0, 0.0, -5.0, 0.0));
      return;
    case Layer::Particles:
      painter.setPen(QPen(colours.particle(1.0), 4.0, Qt::SolidLine, Qt::RoundCap));
      painter.drawPoint(area.center());
      painter.setPen(QPen(colours.particle(0.4), 3.0, Qt::SolidLine, Qt::RoundCap));
      painter.drawPoints(
          QPolygonF({area.topLeft() + QPointF(4.0, 2.0), area.bottomRight() - QPointF(5.0, 2.0),
                     area.bottomLeft() + QPointF(9.0, -1.0)}));
      return;
    default:
      painter.setPen(colours.pen(role));
      painter.drawLine(QPointF(area.left(), area.center().y()),
                       QPointF(area.right(), area.center().y()));
  }
}

}  // namespace

LayersPanel::LayersPanel(QWidget* parent) : QWidget(parent) {
  available_.fill(true);
  auto* layout = new QGridLayout(this);
  layout->setVerticalSpacing(0);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->setColumnStretch(0, 1);
  int row = 0;
  for (const LayerSpec& spec : kLayers) {
    const auto at = static_cast<std::size_t>(spec.layer);
    auto* check = new QCheckBox(tr(spec.text));
    check->setToolTip(tr(spec.hint));
    check->setObjectName(QStringLiteral("layer.%1").arg(static_cast<int>(spec.layer)));
    check->setIconSize(kSample);
    check->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // a panel may be narrow
    check->setChecked(spec.usual);
    boxes_[at] = check;
    connect(check, &QCheckBox::toggled, this, [this, layer = spec.layer](bool on) {
      if (isAvailable(layer)) Q_EMIT toggled(layer, on);
    });
    layout->addWidget(check, row, 0);
    if (hasOpacity(spec.layer)) layout->addWidget(sliders_[at] = makeSlider(spec), row, 1);
    ++row;
  }
  legend_ = new QWidget;
  auto* legend = new QVBoxLayout(legend_);
  legend->setContentsMargins({});
  legend->setSpacing(0);
  layout->addWidget(legend_, row++, 0, 1, 2);
  for (const auto& [sample, text] :
       {std::pair(&unseen_sample_, tr("A wall that nobody saw")),
        std::pair(&doubtful_sample_, tr("A doubtful building: point at it to read why"))}) {
    auto* line = new QHBoxLayout;
    line->setContentsMargins(kBesideBox, 2, 0, 0);
    line->addWidget(*sample = new QLabel);
    auto* words = new QLabel(text);
    words->setWordWrap(true);
    line->addWidget(words, 1);
    legend->addLayout(line);
  }
  layout->setRowStretch(row, 1);
  paintSamples();
}

QSlider* LayersPanel::makeSlider(const LayerSpec& spec) {
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setRange(kLeastPercent, 100);
  slider->setValue(100);
  slider->setFixedWidth(kSliderWidth);
  slider->setAccessibleName(tr("%1: how strongly it is drawn").arg(tr(spec.text)));
  slider->setToolTip(tr("How strongly it is drawn"));
  connect(slider, &QSlider::valueChanged, this, [this, layer = spec.layer](int percent) {
    Q_EMIT opacityChanged(layer, percent / 100.0);
  });
  return slider;
}

QList<std::pair<QPixmap, QString>> LayersPanel::legend() const {
  QList<std::pair<QPixmap, QString>> entries;
  for (const LayerSpec& spec : kLayers) {
    const bool drawn =
        spec.layer != Layer::Grid && spec.layer != Layer::Underlays && spec.layer != Layer::Rays;
    if (drawn && isAvailable(spec.layer) && isOn(spec.layer))
      entries.push_back({box(spec.layer)->icon().pixmap(kSample, 2.0), tr(spec.text)});
  }
  return entries;
}

bool LayersPanel::isOn(Layer layer) const { return box(layer)->isChecked(); }
void LayersPanel::setOn(Layer layer, bool on) { box(layer)->setChecked(on); }
bool LayersPanel::isAvailable(Layer layer) const {
  return available_[static_cast<std::size_t>(layer)];
}

void LayersPanel::setAvailable(Layer layer, bool available) {
  if (available == isAvailable(layer)) return;
  available_[static_cast<std::size_t>(layer)] = available;
  box(layer)->setVisible(available);
  if (QSlider* slider = sliders_[static_cast<std::size_t>(layer)]) slider->setVisible(available);
  if (layer == Layer::Corrected) legend_->setVisible(available);
  if (isOn(layer)) Q_EMIT toggled(layer, available);
}

void LayersPanel::setRun(bool exists, bool has_particles) {
  for (const LayerSpec& spec : kLayers) {
    const bool sampled = spec.layer == Layer::Particles || spec.layer == Layer::Swarms;
    if (spec.of_run) setAvailable(spec.layer, exists && (has_particles || !sampled));
  }
}

namespace {

QString keyOf(const LayerSpec& spec, const char* what) {
  return QStringLiteral("layers/%1/%2").arg(QLatin1String(spec.id), QLatin1String(what));
}

}  // namespace

void LayersPanel::save(QSettings& settings) const {
  for (const LayerSpec& spec : kLayers) {
    settings.setValue(keyOf(spec, "shown"), isOn(spec.layer));
    const QSlider* slider = sliders_[static_cast<std::size_t>(spec.layer)];
    if (slider) settings.setValue(keyOf(spec, "percent"), slider->value());
  }
}

void LayersPanel::restore(const QSettings& settings) {
  for (const LayerSpec& spec : kLayers) {
    setOn(spec.layer, settings.value(keyOf(spec, "shown"), spec.usual).toBool());
    QSlider* slider = sliders_[static_cast<std::size_t>(spec.layer)];
    if (slider) slider->setValue(settings.value(keyOf(spec, "percent"), 100).toInt());
  }
}

void LayersPanel::paintSamples() {
  const Colours& colours = Colours::of(palette());
  const auto painted = [this](auto paint) {
    QPixmap sample(kSample * devicePixelRatioF());
    sample.setDevicePixelRatio(devicePixelRatioF());
    sample.fill(Qt::transparent);
    QPainter painter(&sample);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter);
    return sample;
  };
  for (const LayerSpec& spec : kLayers) {
    box(spec.layer)->setIcon(painted([&](QPainter& painter) {
      paintSample(painter, spec, colours);
    }));
  }
  unseen_sample_->setPixmap(painted([&](QPainter& painter) {
    painter.setPen(CorrectedMapItem::unseenPen(colours));
    painter.drawLine(2, kSample.height() / 2, kSample.width() - 2, kSample.height() / 2);
  }));
  doubtful_sample_->setPixmap(painted([&](QPainter& painter) {
    painter.fillRect(QRect({2, 2}, kSample - QSize(4, 4)), colours.brush(Role::Doubtful));
  }));
}

void LayersPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) paintSamples();
  QWidget::changeEvent(event);
}

}  // namespace handmap
