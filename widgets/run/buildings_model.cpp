#include "widgets/run/buildings_model.h"

#include <algorithm>
#include <array>

namespace handmap {

namespace {

struct ColumnText {
  const char* title;
  const char* hint;
};

constexpr std::array<ColumnText, BuildingsModel::ColumnCount> kColumnTexts = {{
    {"Id", QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Of the building in the drawing")},
    {"x", QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Corrected centre, metres")},
    {"\u03c3x", QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Standard deviation of x, metres")},
    {"w",
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Corrected width along its heading, metres")},
    {"\u03c3w",
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Standard deviation of the width, metres")},
    {"\u0394x",
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Corrected minus drawn centre, metres")},
    {"\u0394y",
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Corrected minus drawn centre, metres")},
    {"\u0394w",
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Corrected minus drawn width, metres")},
}};

}  // namespace

void BuildingsModel::setDrawing(Map drawing) {
  beginResetModel();
  drawing_ = std::move(drawing);
  rows_.clear();
  endResetModel();
}

void BuildingsModel::setRefined(const Map& refined) {
  std::vector<Row> rows;
  // The buildings of a refined map stand where those of its drawing do.
  const std::size_t count = std::min(refined.buildings.size(), drawing_.buildings.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Building& building = refined.buildings[i];
    if (!building.estimate) continue;
    const Rectangle now = building.box();
    const Rectangle before = drawing_.buildings[i].box();
    const Vec2 moved = now.centre - before.centre;
    rows.push_back(
        {QString::fromStdString(building.id),
         {0.0, now.centre.x(), building.estimate->sigma_x, now.width,
          building.estimate->sigma_width, moved.x(), moved.y(), now.width - before.width}});
  }
  if (rows.size() != rows_.size()) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
  } else if (rows != rows_) {
    rows_ = std::move(rows);
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
}

QString BuildingsModel::idAt(int row) const { return rows_.at(static_cast<std::size_t>(row)).id; }

int BuildingsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int BuildingsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant BuildingsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_.at(static_cast<std::size_t>(index.row()));
  const int column = index.column();
  if (role == Qt::TextAlignmentRole) {
    return QVariant(Qt::AlignVCenter | (column == Id ? Qt::AlignLeft : Qt::AlignRight));
  }
  if (role != Qt::DisplayRole) return {};
  if (column == Id) return row.id;
  const double metres = row.metres.at(static_cast<std::size_t>(column));
  QString text = QString::number(metres, 'f', 2);
  if (column >= MovedX && metres > 0.0) text.prepend(QLatin1Char('+'));
  return text;
}

QVariant BuildingsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const ColumnText& text = kColumnTexts.at(static_cast<std::size_t>(section));
  if (role == Qt::DisplayRole) return QString::fromUtf8(text.title);
  if (role == Qt::ToolTipRole) return tr(text.hint);
  return {};
}

}  // namespace handmap
