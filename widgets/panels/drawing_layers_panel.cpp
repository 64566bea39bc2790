#include "widgets/panels/drawing_layers_panel.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

constexpr int kSliderPercent = 100;
constexpr int kMostRowsShown = 8;
enum Column { NameColumn, ShownColumn, LockedColumn, Columns };

QString nameOf(DrawingLayer layer) {
  switch (layer) {
    case DrawingLayer::Buildings:
      return DrawingLayersPanel::tr("Buildings");
    case DrawingLayer::Landmarks:
      return DrawingLayersPanel::tr("Landmarks");
    case DrawingLayer::Start:
      return DrawingLayersPanel::tr("Start");
    case DrawingLayer::Route:
      return DrawingLayersPanel::tr("Route");
    case DrawingLayer::Count:
      break;
  }
  return {};
}

LayerState stateOf(const Underlay& underlay) {
  return {underlay.flags.hidden, underlay.flags.locked, underlay.opacity};
}

}  // namespace

DrawingLayersPanel::DrawingLayersPanel(MapDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      tree_(new QTreeWidget),
      opacity_(new QSlider(Qt::Horizontal)) {
  tree_->setObjectName(QStringLiteral("drawing_layers"));
  tree_->setAccessibleName(tr("Layers of the drawing"));
  tree_->setColumnCount(Columns);
  tree_->setHeaderLabels({tr("Of the drawing"), tr("Shown"), tr("Locked")});
  tree_->setRootIsDecorated(false);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
  for (const int column : {ShownColumn, LockedColumn})
    tree_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  opacity_->setObjectName(QStringLiteral("layer_opacity"));
  opacity_->setAccessibleName(tr("Opacity of the layer"));
  opacity_->setRange(0, kSliderPercent);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(tree_);
  auto* form = new QFormLayout;
  form->addRow(tr("Opacity"), opacity_);
  layout->addLayout(form);
  connect(tree_, &QTreeWidget::itemChanged, this, &DrawingLayersPanel::take);
  connect(tree_, &QTreeWidget::currentItemChanged, this, &DrawingLayersPanel::refreshSlider);
  connect(opacity_, &QSlider::valueChanged, this, [this](int percent) {
    if (filling_ || chosen().isEmpty()) return;
    LayerState state = stateOfRow(chosen());
    state.opacity = static_cast<double>(percent) / kSliderPercent;
    setState(chosen(), state, tr("Fade Layer"), true);
  });
  connect(opacity_, &QSlider::sliderReleased, &document_, &MapDocument::finishMerging);
  connect(&document_, &MapDocument::mapChanged, this, [this](const Touched& touched) {
    if (touched.layers || touched.underlays) rebuild();
  });
  rebuild();
}

QString DrawingLayersPanel::chosen() const {
  const QTreeWidgetItem* row = tree_->currentItem();
  return row ? row->data(NameColumn, Qt::UserRole).toString() : QString();
}

void DrawingLayersPanel::rebuild() {
  const QString before = chosen();
  filling_ = true;
  tree_->clear();
  const LayerStates layers = document_.map().layers;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const auto layer = static_cast<DrawingLayer>(i);
    addRow(QString::number(i), nameOf(layer), layers[i]);
    if (layer == DrawingLayer::Route)
      tree_->topLevelItem(static_cast<int>(i))
          ->setToolTip(NameColumn, tr("While a run is shown: only where it is selected or drawn"));
  }
  const std::vector<Underlay>& pictures = document_.map().underlays;
  for (std::size_t i = pictures.size(); i-- > 0;)  // the topmost first
    addRow(pictureKey(i), displayName(document_.map(), pictureKey(i)), stateOf(pictures[i]));
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = tree_->topLevelItem(i);
    if (row->data(NameColumn, Qt::UserRole).toString() == before) tree_->setCurrentItem(row);
  }
  const int rows = std::min(tree_->topLevelItemCount(), kMostRowsShown);
  tree_->setFixedHeight(tree_->header()->sizeHint().height() + rows * tree_->sizeHintForRow(0) +
                        2 * tree_->frameWidth() + 2);
  filling_ = false;
  refreshSlider();
}

void DrawingLayersPanel::addRow(const QString& key, const QString& name, const LayerState& state) {
  auto* row = new QTreeWidgetItem(tree_, {name});
  row->setData(NameColumn, Qt::UserRole, key);
  row->setToolTip(NameColumn, name);
  row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  row->setCheckState(ShownColumn, state.hidden ? Qt::Unchecked : Qt::Checked);
  row->setCheckState(LockedColumn, state.locked ? Qt::Checked : Qt::Unchecked);
  row->setData(ShownColumn, Qt::AccessibleTextRole, tr("Shown"));
  row->setData(LockedColumn, Qt::AccessibleTextRole, tr("Locked"));
}

LayerState DrawingLayersPanel::stateOfRow(const QString& key) const {
  if (const auto place = pictureIndex(key)) return stateOf(document_.map().underlays.at(*place));
  return document_.map().layers.at(key.toULongLong());
}

void DrawingLayersPanel::setState(const QString& key, const LayerState& state, const QString& text,
                                  bool mergeable) {
  if (const auto place = pictureIndex(key)) {
    std::vector<Underlay> pictures = document_.map().underlays;
    if (*place >= pictures.size()) return;  // gone meanwhile
    Underlay& picture = pictures[*place];
    picture.flags.hidden = state.hidden;
    picture.flags.locked = state.locked;
    picture.opacity = state.opacity;
    return document_.setUnderlays(std::move(pictures), text, mergeable);
  }
  LayerStates layers = document_.map().layers;
  layers.at(key.toULongLong()) = state;
  document_.setLayers(layers, text, mergeable);
}

void DrawingLayersPanel::take(QTreeWidgetItem* row, int column) {
  if (filling_) return;
  const QString key = row->data(NameColumn, Qt::UserRole).toString();
  LayerState state = stateOfRow(key);
  const bool on = row->checkState(column) == Qt::Checked;
  if (column == ShownColumn) state.hidden = !on;
  if (column == LockedColumn) state.locked = on;
  // The rows are made anew, this one too, when the view is done with it.
  QMetaObject::invokeMethod(
      this,
      [this, key, state, column] {
        setState(key, state, column == ShownColumn ? tr("Show or Hide Layer") : tr("Lock Layer"),
                 false);
      },
      Qt::QueuedConnection);
}

void DrawingLayersPanel::refreshSlider() {
  if (filling_) return;
  filling_ = true;
  const QString key = chosen();
  opacity_->setEnabled(!key.isEmpty());
  const double opacity = key.isEmpty() ? 1.0 : stateOfRow(key).opacity;
  opacity_->setValue(static_cast<int>(std::lround(kSliderPercent * opacity)));
  filling_ = false;
}

}  // namespace handmap
