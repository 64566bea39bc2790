#include "widgets/panels/object_tree_model.h"

#include <algorithm>

#include "widgets/style/icons.h"

namespace handmap {

namespace {

constexpr int kMaxNameLength = 1000;  // UTF-16 units; a map file takes 4096 bytes

template <typename Item>
std::vector<std::string> idsOf(const std::vector<Item>& items) {
  std::vector<std::string> ids;
  ids.reserve(items.size());
  for (const Item& item : items) ids.push_back(item.id);
  return ids;
}

template <typename Item>
bool haveIds(const std::vector<Item>& items, const std::vector<std::string>& ids) {
  return std::ranges::equal(items, ids, {}, &Item::id);
}

std::unordered_map<std::string, std::size_t> rowsBy(const std::vector<std::string>& ids) {
  std::unordered_map<std::string, std::size_t> rows;
  rows.reserve(ids.size());
  for (std::size_t row = 0; row < ids.size(); ++row) rows.emplace(ids[row], row);
  return rows;
}

std::size_t placeOf(const QModelIndex& index) { return static_cast<std::size_t>(index.row()); }

}  // namespace

ObjectTreeModel::ObjectTreeModel(MapDocument& document, QObject* parent)
    : QAbstractItemModel(parent),
      document_(document),
      start_icon_(icon(QLatin1String("start"))),
      route_icon_(icon(QLatin1String("route"))),
      box_icon_(icon(QLatin1String("rectangle"))),
      outline_icon_(icon(QLatin1String("polygon"))),
      landmark_icon_(icon(QLatin1String("landmark"))),
      picture_icon_(icon(QLatin1String("picture"))) {
  take(rowsOfMap());
}

ObjectTreeModel::Rows ObjectTreeModel::rowsOfMap() const {
  const Map& map = document_.map();
  Rows rows{{}, idsOf(map.buildings), idsOf(map.landmarks), map.underlays.size()};
  if (map.start) rows.tops.push_back(Kind::Start);
  if (!map.route.empty()) rows.tops.push_back(Kind::Route);
  rows.tops.push_back(Kind::Buildings);
  if (!rows.landmarks.empty()) rows.tops.push_back(Kind::Landmarks);
  if (rows.pictures > 0) rows.tops.push_back(Kind::Pictures);
  return rows;
}

bool ObjectTreeModel::agreesWithMap() const {
  const Map& map = document_.map();
  const auto has = [&](Kind kind) { return std::ranges::count(rows_.tops, kind) > 0; };
  return has(Kind::Start) == map.start.has_value() && has(Kind::Route) == !map.route.empty() &&
         rows_.pictures == map.underlays.size() && haveIds(map.buildings, rows_.buildings) &&
         haveIds(map.landmarks, rows_.landmarks);
}

void ObjectTreeModel::take(Rows rows) {
  rows_ = std::move(rows);
  looks_.clear();
  for (const Building& building : document_.map().buildings) looks_.push_back(lookOf(building));
  building_rows_ = rowsBy(rows_.buildings);
  landmark_rows_ = rowsBy(rows_.landmarks);
}

void ObjectTreeModel::follow(const Touched& touched) {
  const bool same_objects =
      !(touched.listed || touched.landmarks || touched.start || touched.route || touched.underlays);
  if (same_objects || agreesWithMap()) {
    for (int top = 0; top < rowCount(); ++top) {
      const QModelIndex node = index(top, 0);
      const int rows = rowCount(node);
      Q_EMIT dataChanged(node, node.siblingAtColumn(Columns - 1));
      if (kindOf(node) == Kind::Buildings) {
        tellChangedBuildings(node, touched);
      } else if (rows > 0) {
        Q_EMIT dataChanged(index(0, 0, node), index(rows - 1, Columns - 1, node));
      }
    }
    return;
  }
  beginResetModel();
  take(rowsOfMap());
  endResetModel();
}

ObjectTreeModel::Look ObjectTreeModel::lookOf(const Building& building) {
  return {building.name,
          {building.flags.hidden, building.flags.locked},
          std::holds_alternative<Rectangle>(building.shape)};
}

/// Each alone: a filter looks at every row that is told, and most drags change none.
void ObjectTreeModel::tellChangedBuildings(const QModelIndex& node, const Touched& touched) {
  const std::vector<Building>& buildings = document_.map().buildings;
  const auto tell = [&](std::size_t b) {
    Look look = lookOf(buildings[b]);
    if (look == looks_[b]) return;
    looks_[b] = std::move(look);
    const QModelIndex row = index(static_cast<int>(b), 0, node);
    Q_EMIT dataChanged(row, row.siblingAtColumn(Columns - 1));
  };
  if (touched.listed)
    for (std::size_t b = 0; b < buildings.size(); ++b) tell(b);
  else
    std::ranges::for_each(touched.buildings, tell);
}

QModelIndex ObjectTreeModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  if (!parent.isValid()) return createIndex(row, column, quintptr{0});
  return createIndex(row, column, static_cast<quintptr>(parent.row()) + 1);
}

QModelIndex ObjectTreeModel::parent(const QModelIndex& index) const {
  if (!index.isValid() || isTop(index)) return {};
  return createIndex(static_cast<int>(index.internalId()) - 1, 0, quintptr{0});
}

int ObjectTreeModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return static_cast<int>(rows_.tops.size());
  if (!isTop(parent) || parent.column() != 0) return 0;
  return static_cast<int>(countOf(kindOf(parent)));
}

int ObjectTreeModel::columnCount(const QModelIndex&) const { return Columns; }

ObjectTreeModel::Kind ObjectTreeModel::kindOf(const QModelIndex& index) const {
  return rows_.tops[isTop(index) ? placeOf(index) : index.internalId() - 1];
}

/// Under the node of a kind.
std::size_t ObjectTreeModel::countOf(Kind kind) const {
  switch (kind) {
    case Kind::Buildings:
      return rows_.buildings.size();
    case Kind::Landmarks:
      return rows_.landmarks.size();
    case Kind::Pictures:
      return rows_.pictures;
    default:
      return 0;
  }
}

QModelIndex ObjectTreeModel::indexOf(const QString& key) const {
  const auto node = [this](Kind kind) {
    const auto found = std::ranges::find(rows_.tops, kind);
    return found == rows_.tops.end() ? QModelIndex()
                                     : index(static_cast<int>(found - rows_.tops.begin()), 0);
  };
  const auto under = [&](Kind kind, std::size_t row) {
    return index(static_cast<int>(row), 0, node(kind));
  };
  if (key == kStartKey) return node(Kind::Start);
  if (key == kRouteKey) return node(Kind::Route);
  if (const auto place = pictureIndex(key)) {
    return *place < rows_.pictures ? under(Kind::Pictures, *place) : QModelIndex();
  }
  const std::string id = key.toStdString();
  if (const auto row = building_rows_.find(id); row != building_rows_.end()) {
    return under(Kind::Buildings, row->second);
  }
  const auto row = landmark_rows_.find(id);
  return row == landmark_rows_.end() ? QModelIndex() : under(Kind::Landmarks, row->second);
}

QStringList ObjectTreeModel::keysUnder(const QModelIndex& index) const {
  const QString own = keyOf(index);
  if (!own.isEmpty()) return {own};
  QStringList keys;
  for (int row = 0; row < rowCount(index); ++row) keys << keyOf(this->index(row, 0, index));
  return keys;
}

QString ObjectTreeModel::keyOf(const QModelIndex& index) const {
  switch (kindOf(index)) {
    case Kind::Start:
      return kStartKey;
    case Kind::Route:
      return kRouteKey;
    default:
      break;
  }
  if (isTop(index)) return {};
  switch (kindOf(index)) {
    case Kind::Buildings:
      return QString::fromStdString(rows_.buildings[placeOf(index)]);
    case Kind::Landmarks:
      return QString::fromStdString(rows_.landmarks[placeOf(index)]);
    default:
      return pictureKey(placeOf(index));
  }
}

QString ObjectTreeModel::nameOf(const QModelIndex& index) const {
  if (isTop(index)) return {};
  const Map& map = document_.map();
  const std::size_t row = placeOf(index);
  switch (kindOf(index)) {
    case Kind::Buildings:
      return row < map.buildings.size() ? QString::fromStdString(map.buildings[row].name)
                                        : QString();
    case Kind::Landmarks:
      return row < map.landmarks.size() ? QString::fromStdString(map.landmarks[row].name)
                                        : QString();
    default:
      return {};
  }
}

QString ObjectTreeModel::titleOf(Kind kind) const {
  switch (kind) {
    case Kind::Start:
      return tr("Start");
    case Kind::Route:
      return tr("Route");
    case Kind::Buildings:
      return tr("Buildings (%1)").arg(countOf(kind));
    case Kind::Landmarks:
      return tr("Landmarks (%1)").arg(countOf(kind));
    case Kind::Pictures:
      break;
  }
  return tr("Pictures (%1)").arg(countOf(kind));
}

QString ObjectTreeModel::textOf(const QModelIndex& index) const {
  const Kind kind = kindOf(index);
  if (isTop(index)) return titleOf(kind);
  const QString key = keyOf(index);
  if (kind == Kind::Pictures) return displayName(document_.map(), key);
  const QString name = nameOf(index);
  return name.isEmpty() ? key : QStringLiteral("%1 · %2").arg(key, name);
}

/// For screen readers: what it is as well.
QString ObjectTreeModel::spoken(const QModelIndex& index) const {
  if (isTop(index)) return textOf(index);
  switch (kindOf(index)) {
    case Kind::Buildings:
      return tr("Building %1").arg(textOf(index));
    case Kind::Landmarks:
      return tr("Landmark %1").arg(textOf(index));
    default:
      return tr("Picture %1").arg(textOf(index));
  }
}

QIcon ObjectTreeModel::iconOf(const QModelIndex& index) const {
  switch (kindOf(index)) {
    case Kind::Start:
      return start_icon_;
    case Kind::Route:
      return route_icon_;
    case Kind::Landmarks:
      return landmark_icon_;
    case Kind::Pictures:
      return picture_icon_;
    case Kind::Buildings:
      break;
  }
  const Map& map = document_.map();
  if (isTop(index) || placeOf(index) >= map.buildings.size()) return box_icon_;
  const bool is_box = std::holds_alternative<Rectangle>(map.buildings[placeOf(index)].shape);
  return is_box ? box_icon_ : outline_icon_;
}

/// Pictures have none.
DrawingLayer ObjectTreeModel::layerOf(Kind kind) {
  switch (kind) {
    case Kind::Start:
      return DrawingLayer::Start;
    case Kind::Route:
      return DrawingLayer::Route;
    case Kind::Landmarks:
      return DrawingLayer::Landmarks;
    default:
      return DrawingLayer::Buildings;
  }
}

/// nullopt: it cannot be hidden and locked as a whole.
std::optional<ObjectTreeModel::State> ObjectTreeModel::stateOf(const QModelIndex& index) const {
  const Map& map = document_.map();
  const Kind kind = kindOf(index);
  const std::size_t row = placeOf(index);
  if (isTop(index)) {
    if (kind == Kind::Pictures) return std::nullopt;
    const LayerStates layers = map.layers;
    const LayerState& state = handmap::stateOf(layers, layerOf(kind));
    return State{state.hidden, state.locked};
  }
  if (kind == Kind::Buildings && row < map.buildings.size()) {
    return State{map.buildings[row].flags.hidden, map.buildings[row].flags.locked};
  }
  if (kind == Kind::Landmarks && row < map.landmarks.size()) {
    return State{map.landmarks[row].flags.hidden, map.landmarks[row].flags.locked};
  }
  if (kind == Kind::Pictures && row < map.underlays.size()) {
    return State{map.underlays[row].flags.hidden, map.underlays[row].flags.locked};
  }
  return std::nullopt;
}

QVariant ObjectTreeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (role == KeyRole) return keyOf(index);
  if (role == NodeRole) return static_cast<int>(kindOf(index));
  if (index.column() == NameColumn) {
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole) return textOf(index);
    if (role == Qt::EditRole) return nameOf(index);
    if (role == Qt::DecorationRole) return iconOf(index);
    if (role == Qt::AccessibleTextRole) return spoken(index);
    return {};
  }
  if (role != Qt::CheckStateRole && role != Qt::AccessibleTextRole) return {};
  const auto state = stateOf(index);
  if (!state) return {};
  if (index.column() == ShownColumn) {
    if (role == Qt::CheckStateRole) return state->hidden ? Qt::Unchecked : Qt::Checked;
    return state->hidden ? tr("hidden") : tr("shown");
  }
  if (role == Qt::CheckStateRole) return state->locked ? Qt::Checked : Qt::Unchecked;
  return state->locked ? tr("locked") : tr("not locked");
}

QVariant ObjectTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
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
      return role == Qt::ToolTipRole
                 ? tr("What is locked is not moved, resized or deleted by hand; whether a run may "
                      "move a building is set in its properties")
                 : QVariant();
    default:
      return {};
  }
}

Qt::ItemFlags ObjectTreeModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractItemModel::flags(index);
  if (!index.isValid()) return flags;
  if (index.column() != NameColumn) {
    return stateOf(index) ? flags | Qt::ItemIsUserCheckable : flags;
  }
  const Kind kind = kindOf(index);
  const bool has_name = !isTop(index) && (kind == Kind::Buildings || kind == Kind::Landmarks);
  return has_name ? flags | Qt::ItemIsEditable : flags;
}

bool ObjectTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid()) return false;
  if (role == Qt::EditRole && index.column() == NameColumn) return rename(index, value.toString());
  if (role != Qt::CheckStateRole || index.column() == NameColumn) return false;
  return setFlag(index, value.toInt() == Qt::Checked);
}

bool ObjectTreeModel::rename(const QModelIndex& index, const QString& name) {
  MapChange change = selected(document_.map(), {keyOf(index)});
  const std::string given = name.left(kMaxNameLength).toStdString();
  for (Building& building : change.buildings) building.name = given;
  for (Landmark& landmark : change.landmarks) landmark.name = given;
  document_.apply(change, tr("Name %1").arg(keyOf(index)));
  return true;
}

bool ObjectTreeModel::setFlag(const QModelIndex& index, bool on) {
  if (!stateOf(index)) return false;
  const bool is_lock = index.column() == LockedColumn;
  bool Flags::*flag = is_lock ? &Flags::locked : &Flags::hidden;
  const bool wanted = is_lock ? on : !on;
  const QString name = textOf(index);
  const QString text = is_lock ? tr("Lock %1").arg(name) : tr("Show or Hide %1").arg(name);
  if (isTop(index)) return setLayerFlag(kindOf(index), is_lock, wanted, text);
  if (kindOf(index) == Kind::Pictures) {
    std::vector<Underlay> pictures = document_.map().underlays;
    pictures[placeOf(index)].flags.*flag = wanted;
    document_.setUnderlays(std::move(pictures), text);
    return true;
  }
  MapChange change = selected(document_.map(), {keyOf(index)});
  for (Building& building : change.buildings) building.flags.*flag = wanted;
  for (Landmark& landmark : change.landmarks) landmark.flags.*flag = wanted;
  document_.apply(change, text);
  return true;
}

bool ObjectTreeModel::setLayerFlag(Kind kind, bool is_lock, bool wanted, const QString& text) {
  LayerStates layers = document_.map().layers;
  LayerState& state = layers[static_cast<std::size_t>(layerOf(kind))];
  (is_lock ? state.locked : state.hidden) = wanted;
  document_.setLayers(layers, text);
  return true;
}

}  // namespace handmap
