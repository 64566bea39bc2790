#include "widgets/run/layers_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>

namespace handmap {

namespace {

constexpr QSize kSample(34, 16);

void paintSample(QPainter& painter, Role role, const Colours& colours) {
  const QRectF area = QRectF(QPointF(), kSample).adjusted(2.0, 3.0, -2.0, -3.0);
  switch (role) {
    case Role::CorrectedBand:
      painter.fillRect(area, colours.brush(role));
      return;
    case Role::LocalMap:
      painter.fillRect(area, colours[role]);
      return;
    case Role::Particle:
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
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(0);
  layout->setContentsMargins(8, 4, 4, 4);
  for (const LayerSpec& spec : kLayers) {
    auto* check = new QCheckBox(tr(spec.text));
    check->setToolTip(tr(spec.hint));
    check->setObjectName(QStringLiteral("layer.%1").arg(static_cast<int>(spec.layer)));
    check->setIconSize(kSample);
    check->setChecked(true);
    boxes_[static_cast<std::size_t>(spec.layer)] = check;
    connect(check, &QCheckBox::toggled, this,
            [this, layer = spec.layer](bool on) { Q_EMIT toggled(layer, on); });
    layout->addWidget(check);
  }
  layout->addStretch();
  paintSamples();
}

bool LayersPanel::isOn(Layer layer) const { return box(layer)->isChecked(); }
void LayersPanel::setOn(Layer layer, bool on) { box(layer)->setChecked(on); }
void LayersPanel::setAvailable(Layer layer, bool available) { box(layer)->setEnabled(available); }

void LayersPanel::paintSamples() {
  const Colours& colours = Colours::of(palette());
  for (const LayerSpec& spec : kLayers) {
    QPixmap sample(kSample * devicePixelRatioF());
    sample.setDevicePixelRatio(devicePixelRatioF());
    sample.fill(Qt::transparent);
    QPainter painter(&sample);
    painter.setRenderHint(QPainter::Antialiasing);
    paintSample(painter, spec.role, colours);
    painter.end();
    box(spec.layer)->setIcon(sample);
  }
}

void LayersPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) paintSamples();
  QWidget::changeEvent(event);
}

}  // namespace handmap
