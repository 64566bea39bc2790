#include "widgets/panels/object_list_model.h"

#include <algorithm>

#include "widgets/style/icons.h"

namespace handmap {

namespace {

enum Kind { Start, Route, Rectangular, Polygonal, Place };

QString textOf(const std::string& id, const std::string& name) {
  const QString key = QString::fromStdString(id);
  return name.empty() ? key : QStringLiteral("%1 · %2").arg(key, QString::fromStdString(name));
}

}  // namespace

ObjectListModel::ObjectListModel(const MapDocument& document, QObject* parent)
    : QAbstractListModel(parent), document_(document) {
  for (const char* name : {"start", "route", "rectangle", "polygon", "landmark"})
    icons_.push_back(icon(QLatin1String(name)));
  rows_ = rowsOfMap();
}

std::vector<ObjectListModel::Row> ObjectListModel::rowsOfMap() const {
  const Map& map = document_.map();
  std::vector<Row> rows;
  if (map.start) rows.push_back({kStartKey, tr("Start"), Start});
  if (!map.route.empty()) rows.push_back({kRouteKey, tr("Route"), Route});
  for (const Building& building : map.buildings) {
    const bool is_polygon = std::holds_alternative<handmap::Polygon>(building.shape);
    rows.push_back({QString::fromStdString(building.id), textOf(building.id, building.name),
                    is_polygon ? Polygonal : Rectangular});
  }
  for (const Landmark& landmark : map.landmarks)
    rows.push_back(
        {QString::fromStdString(landmark.id), textOf(landmark.id, landmark.name), Place});
  return rows;
}

void ObjectListModel::rebuild() {
  std::vector<Row> rows = rowsOfMap();
  if (std::ranges::equal(rows, rows_, {}, &Row::key, &Row::key)) {
    rows_ = std::move(rows);
    if (!rows_.empty()) Q_EMIT dataChanged(index(0), index(rowCount() - 1));
    return;
  }
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int ObjectListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant ObjectListModel::data(const QModelIndex& index, int role) const {
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return row.text;
    case Qt::DecorationRole:
      return icons_[static_cast<std::size_t>(row.icon)];
    case KeyRole:
      return row.key;
    default:
      return {};
  }
}

}  // namespace handmap
