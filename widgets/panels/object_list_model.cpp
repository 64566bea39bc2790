#include "widgets/panels/object_list_model.h"

#include <algorithm>

#include "core/map/map_flags.h"
#include "widgets/style/icons.h"

namespace handmap {

namespace {

constexpr int kMaxNameLength = 1000;  // UTF-16 units; a map file takes 4096 bytes

QString textOf(const QString& key, const QString& name) {
  return name.isEmpty() ? key : QStringLiteral("%1 · %2").arg(key, name);
}

/// The one object of that id, changed.
template <typename Item>
std::vector<Item> changedItem(const std::vector<Item>& items, const QString& id, auto change) {
  for (const Item& item : items) {
    if (QString::fromStdString(item.id) != id) continue;
    Item changed = item;
    change(changed);
    return {changed};
  }
  return {};
}

}  // namespace

ObjectListModel::ObjectListModel(MapDocument& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
  for (const char* name : {"start", "route", "rectangle", "polygon", "landmark", "picture"})
    icons_.push_back(icon(QLatin1String(name)));
  rows_ = rowsOfMap();
}

std::vector<ObjectListModel::Row> ObjectListModel::rowsOfMap() const {
  const Map& map = document_.map();
  const LayerStates layers = layersOf(map);
  const LayerState& start = stateOf(layers, DrawingLayer::Start);
  const LayerState& route = stateOf(layers, DrawingLayer::Route);
  std::vector<Row> rows;
  rows.reserve(map.buildings.size() + map.landmarks.size() + map.underlays.size() + 2);
  if (map.start)
    rows.push_back({kStartKey, tr("Start"), {}, Kind::Start, start.hidden, start.locked});
  if (!map.route.empty())
    rows.push_back({kRouteKey, tr("Route"), {}, Kind::Route, route.hidden, route.locked});
  const auto add = [&](const auto& item, Kind kind, bool locked) {
    const QString key = QString::fromStdString(item.id);
    const QString name = QString::fromStdString(item.name);
    rows.push_back({key, textOf(key, name), name, kind, isHidden(item), locked});
  };
  for (const Building& building : map.buildings) {
    const bool is_polygon = std::holds_alternative<handmap::Polygon>(building.shape);
    add(building, is_polygon ? Kind::Outline : Kind::Box, building.fixed);
  }
  for (const Landmark& landmark : map.landmarks) add(landmark, Kind::Place, isLocked(landmark));
  for (std::size_t i = 0; i < map.underlays.size(); ++i) {
    const QString key = pictureKey(i);
    rows.push_back({key,
                    displayName(map, key),
                    {},
                    Kind::Picture,
                    isHidden(map.underlays[i]),
                    isLocked(map.underlays[i])});
  }
  return rows;
}

void ObjectListModel::rebuild() {
  std::vector<Row> rows = rowsOfMap();
  if (std::ranges::equal(rows, rows_, {}, &Row::key, &Row::key)) {
    rows_ = std::move(rows);
    if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
    return;
  }
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int ObjectListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ObjectListModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : Columns;
}

QVariant ObjectListModel::data(const QModelIndex& index, int role) const {
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  if (role == KeyRole) return row.key;
  switch (index.column()) {
    case NameColumn:
      if (role == Qt::DisplayRole || role == Qt::ToolTipRole) return row.text;
      if (role == Qt::EditRole) return row.name;
      if (role == Qt::DecorationRole) return icons_[static_cast<std::size_t>(row.kind)];
      break;
    case ShownColumn:
      if (role == Qt::CheckStateRole) return row.hidden ? Qt::Unchecked : Qt::Checked;
      if (role == Qt::AccessibleTextRole) return row.hidden ? tr("hidden") : tr("shown");
      break;
    case LockedColumn:
      if (role == Qt::CheckStateRole) return row.locked ? Qt::Checked : Qt::Unchecked;
      if (role == Qt::AccessibleTextRole) return row.locked ? tr("locked") : tr("not locked");
      break;
    default:
      break;
  }
  return {};
}

QVariant ObjectListModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  switch (section) {
    case NameColumn:
      return role == Qt::DisplayRole ? tr("Object") : QVariant();
    case ShownColumn:
      if (role == Qt::DisplayRole) return tr("Shown");
      return role == Qt::ToolTipRole ? tr("What is hidden still belongs to the drawing")
                                     : QVariant();
    case LockedColumn:
      if (role == Qt::DisplayRole) return tr("Locked");
      return role == Qt::ToolTipRole ? tr("A building that is locked is not moved by a run either")
                                     : QVariant();
    default:
      return {};
  }
}

Qt::ItemFlags ObjectListModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  if (!index.isValid()) return flags;
  if (index.column() != NameColumn) return flags | Qt::ItemIsUserCheckable;
  const Kind kind = rows_[static_cast<std::size_t>(index.row())].kind;
  const bool has_name = kind == Kind::Box || kind == Kind::Outline || kind == Kind::Place;
  return has_name ? flags | Qt::ItemIsEditable : flags;
}

bool ObjectListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const Row row = rows_[static_cast<std::size_t>(index.row())];
  if (role == Qt::EditRole && index.column() == NameColumn) return rename(row, value.toString());
  if (role != Qt::CheckStateRole) return false;
  return setFlag(row, static_cast<Column>(index.column()), value.toInt() == Qt::Checked);
}

bool ObjectListModel::rename(const Row& row, const QString& name) {
  const auto set = [&](auto& item) { item.name = name.left(kMaxNameLength).toStdString(); };
  const Map& map = document_.map();
  document_.apply({.buildings = changedItem(map.buildings, row.key, set),
                   .landmarks = changedItem(map.landmarks, row.key, set)},
                  tr("Name %1").arg(row.key));
  return true;
}

bool ObjectListModel::setFlag(const Row& row, Column column, bool on) {
  const bool is_lock = column == LockedColumn;
  const char* key = is_lock ? kLockedKey : kHiddenKey;
  const bool wanted = is_lock ? on : !on;
  const QString text = is_lock ? tr("Lock %1").arg(row.text) : tr("Show or Hide %1").arg(row.text);
  const auto set = [&](auto& item) { handmap::setFlag(item.unknown, key, wanted); };
  const Map& map = document_.map();
  if (row.kind == Kind::Start || row.kind == Kind::Route) {
    LayerStates layers = layersOf(map);
    const auto layer = row.kind == Kind::Start ? DrawingLayer::Start : DrawingLayer::Route;
    LayerState& state = layers[static_cast<std::size_t>(layer)];
    (is_lock ? state.locked : state.hidden) = wanted;
    document_.setLayers(layers, text);
  } else if (const auto place = pictureIndex(row.key); row.kind == Kind::Picture && place) {
    std::vector<Underlay> pictures = map.underlays;
    set(pictures.at(*place));
    document_.setUnderlays(std::move(pictures), text);
  } else {
    const auto set_building = [&](Building& building) {
      if (is_lock)
        building.fixed = wanted;
      else
        set(building);
    };
    document_.apply({.buildings = changedItem(map.buildings, row.key, set_building),
                     .landmarks = changedItem(map.landmarks, row.key, set)},
                    text);
  }
  return true;
}

}  // namespace handmap
