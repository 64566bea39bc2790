#include "widgets/panels/vertex_table.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/map/map_limits.h"

namespace handmap {

namespace {

constexpr int kShownRows = 6;

QString textOf(double metres) {
  return QString::fromStdString(formatNumber(std::round(metres * 1e3) / 1e3));
}

}  // namespace

VertexTable::VertexTable(QWidget* parent)
    : QWidget(parent),
      table_(new QTableWidget(0, 2)),
      add_(new QPushButton(tr("Add corner"))),
      remove_(new QPushButton(tr("Remove corner"))) {
  table_->setObjectName(QStringLiteral("vertices"));
  table_->setAccessibleName(tr("Corners of the building"));
  table_->setHorizontalHeaderLabels({tr("x, m"), tr("y, m")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setMinimumHeight(kShownRows * fontMetrics().height() * 2);
  add_->setToolTip(tr("In the middle of the edge after the chosen corner"));
  add_->setObjectName(QStringLiteral("add_vertex"));
  remove_->setObjectName(QStringLiteral("remove_vertex"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->addWidget(table_);
  auto* row = new QHBoxLayout;
  row->addWidget(add_);
  row->addWidget(remove_);
  layout->addLayout(row);
  connect(table_, &QTableWidget::itemChanged, this, &VertexTable::take);
  connect(add_, &QPushButton::clicked, this, &VertexTable::addCorner);
  connect(remove_, &QPushButton::clicked, this, &VertexTable::removeCorner);
}

void VertexTable::showPolygon(const Polygon& polygon) {
  if (polygon == polygon_) return;
  polygon_ = polygon;
  fill();
}

void VertexTable::fill() {
  filling_ = true;
  const int row = table_->currentRow();
  const int column = std::max(0, table_->currentColumn());
  table_->setRowCount(static_cast<int>(polygon_.size()));
  for (int i = 0; i < table_->rowCount(); ++i) {
    const Vec2& corner = polygon_[static_cast<std::size_t>(i)];
    for (const int axis : {0, 1})
      table_->setItem(i, axis, new QTableWidgetItem(textOf(corner[axis])));
  }
  if (row >= 0 && row < table_->rowCount()) table_->setCurrentCell(row, column);
  remove_->setEnabled(polygon_.size() > 3);
  add_->setEnabled(polygon_.size() < kMaxPolygonVertices);
  filling_ = false;
}

void VertexTable::take(const QTableWidgetItem* item) {
  if (filling_) return;
  const QString text = item->text();
  const auto number = parseFinite(QString(text).replace(u',', u'.').toStdString());
  Polygon changed = polygon_;
  double& value = changed.at(static_cast<std::size_t>(item->row()))[item->column()];
  if (!number || std::abs(*number) > kMaxCoordinate) {
    fill();
    Q_EMIT refused(tr("“%1” is no number of metres on the map.").arg(text));
    return;
  }
  if (textOf(value) == textOf(*number)) return;  // only its text was rounded
  value = *number;
  propose(std::move(changed));
}

void VertexTable::addCorner() {
  const auto after = static_cast<std::size_t>(std::max(0, table_->currentRow()));
  if (polygon_.empty()) return;
  Polygon changed = polygon_;
  const Vec2 middle = 0.5 * (polygon_[after] + polygon_[(after + 1) % polygon_.size()]);
  changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(after) + 1, middle);
  propose(std::move(changed));
}

void VertexTable::removeCorner() {
  const int row = table_->currentRow();
  if (row < 0 || polygon_.size() <= 3) return;
  Polygon changed = polygon_;
  changed.erase(changed.begin() + row);
  propose(std::move(changed));
}

void VertexTable::propose(Polygon polygon) {
  const double area = signedArea(polygon);
  if (std::abs(area) < kMinPolygonArea || !isSimple(polygon)) {
    fill();
    Q_EMIT refused(tr("The outline would cross itself, or have no area."));
    return;
  }
  if (area < 0.0) std::reverse(polygon.begin() + 1, polygon.end());
  Q_EMIT edited(polygon);
}

}  // namespace handmap
