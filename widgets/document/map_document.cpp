#include "widgets/document/map_document.h"

#include <QFile>
#include <QFileInfo>
#include <QSet>
#include <QUndoCommand>
#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "core/map/certainty.h"
#include "core/map/map_io.h"
#include "core/map/places.h"
#include "core/map/references.h"

namespace handmap {

namespace {

std::filesystem::path nativePath(const QString& path) {
  return QFile::encodeName(path).toStdString();
}

/// Those of `changed` that are in the list and differ from it, at their places.
template <typename Item>
Placed<Item> differing(const std::vector<Item>& changed, const std::vector<Item>& list) {
  constexpr std::size_t kFew = 8;  // faster found one by one than in a table of all
  Placed<Item> result;
  const auto places = changed.size() > kFew ? placesOf(list) : decltype(placesOf(list))();
  const auto place_of = [&](const std::string& id) {
    if (changed.size() <= kFew)
      return static_cast<std::size_t>(std::ranges::find(list, id, &Item::id) - list.begin());
    const auto place = places.find(id);
    return place == places.end() ? list.size() : place->second;
  };
  for (const Item& item : changed) {
    const std::size_t place = place_of(item.id);
    if (place < list.size() && !(list[place] == item)) result.emplace_back(place, item);
  }
  std::ranges::sort(result, {}, &std::pair<std::size_t, Item>::first);
  return result;
}

template <typename Item>
Placed<Item> chosen(const std::vector<Item>& list, const QSet<QString>& keys) {
  Placed<Item> result;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (keys.contains(QString::fromStdString(list[i].id))) result.emplace_back(i, list[i]);
  return result;
}

const Landmark* findLandmark(const Map& map, const std::string& id) {
  const auto found = std::ranges::find(map.landmarks, id, &Landmark::id);
  return found == map.landmarks.end() ? nullptr : &*found;
}

Placed<Underlay> chosenPictures(const std::vector<Underlay>& list, const QSet<QString>& keys) {
  Placed<Underlay> result;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (keys.contains(pictureKey(i))) result.emplace_back(i, list[i]);
  return result;
}

template <typename Item>
QString mergeMark(char kind, const Placed<Item>& items) {
  QString mark;
  for (const auto& entry : items) mark += QStringLiteral("%1%2 ").arg(kind).arg(entry.first);
  return mark;
}

/// What a run found out about a shape says nothing of another one.
void forgetFindings(Building& building) {
  building.estimate.reset();
  forgetCertainty(building);
}

/// The building as a run has corrected it.
Building corrected(Building drawn, const Building& refined) {
  forgetFindings(drawn);
  drawn.shape = refined.shape;
  drawn.estimate = refined.estimate;
  copyCertainty(refined, drawn);
  return drawn;
}

}  // namespace

class MapDocument::Command : public QUndoCommand {
 public:
  Command(MapDocument& document, std::vector<Toggle> toggles, const QString& text,
          QString merge_key)
      : QUndoCommand(text),
        document_(document),
        toggles_(std::move(toggles)),
        merge_key_(std::move(merge_key)) {}

  void redo() override {
    for (Toggle& toggle : toggles_) flip(toggle);
  }
  void undo() override {
    std::for_each(toggles_.rbegin(), toggles_.rend(), [&](Toggle& toggle) { flip(toggle); });
  }
  int id() const override { return merge_key_.isEmpty() ? -1 : 1; }
  /// The map holds the newest values and this command the oldest: the ones between may go.
  bool mergeWith(const QUndoCommand* later) override {
    return static_cast<const Command*>(later)->merge_key_ == merge_key_;
  }

 private:
  void flip(Toggle& toggle) {
    toggle.flip(document_.map_);
    document_.touched_ |= toggle.touched;
  }

  MapDocument& document_;
  std::vector<Toggle> toggles_;
  QString merge_key_;
};

MapDocument::MapDocument(QObject* parent) : QObject(parent) {
  connect(&undo_stack_, &QUndoStack::indexChanged, this, &MapDocument::onIndexChanged);
  connect(&undo_stack_, &QUndoStack::cleanChanged, this, &MapDocument::fileChanged);
}

/// The stack announces that it is cleared; there is nobody left to hear it.
MapDocument::~MapDocument() { undo_stack_.disconnect(this); }

QString MapDocument::displayName() const {
  if (!file_path_.isEmpty()) return QFileInfo(file_path_).fileName();
  return map_.name.empty() ? tr("Untitled") : QString::fromStdString(map_.name);
}

void MapDocument::reset(Map map, QString path, const QString& origin) {
  map_ = std::move(map);
  file_path_ = std::move(path);
  origin_ = origin.isEmpty() ? file_path_ : origin;
  if (!origin_.isEmpty()) origin_ = QFileInfo(origin_).absoluteFilePath();
  trusts_references_ = false;
  touched_ = Touched::everything();
  const bool had_steps = undo_stack_.count() > 0;
  undo_stack_.clear();
  if (!had_steps) onIndexChanged();
  setSelection({});
  Q_EMIT fileChanged();
  Q_EMIT trustChanged();
}

void MapDocument::open(const QString& path) { reset(readMap(nativePath(path)), path); }

void MapDocument::save(const QString& path) {
  Map copy = map_;
  moveReferences(copy, nativePath(origin_), nativePath(path));
  writeMap(copy, nativePath(path));
  file_path_ = path;
  if (origin_.isEmpty()) origin_ = path;
  undo_stack_.setClean();
  Q_EMIT fileChanged();
}

void MapDocument::setModel(const QString& model, const QString& map_path) {
  if (origin_.isEmpty()) origin_ = map_path;
  setMember(&Map::model, referenceFrom(nativePath(origin_), nativePath(model)),
            tr("Save Model with the Map"), false);
}

void MapDocument::setTrustsReferences(bool trusts) {
  if (trusts == trusts_references_) return;
  trusts_references_ = trusts;
  Q_EMIT trustChanged();
}

const BoxIndex& MapDocument::buildingIndex() const {
  if (!building_index_) {
    std::vector<Bounds> boxes;
    boxes.reserve(map_.buildings.size());
    for (const Building& building : map_.buildings) boxes.push_back(handmap::boundsOf(building));
    building_index_.emplace(std::move(boxes));
  }
  return *building_index_;
}

void MapDocument::setSelection(QStringList keys) {
  if (!keys.isEmpty()) {
    constexpr qsizetype kFew = 8;  // faster found one by one than in a table of all
    const bool few = keys.size() <= kFew;
    const auto ids = few ? decltype(takenIds())() : takenIds();
    keys.removeIf([&](const QString& key) {
      if (key == kStartKey) return !map_.start.has_value();
      if (key == kRouteKey) return map_.route.empty();
      if (const auto picture = pictureIndex(key)) return *picture >= map_.underlays.size();
      const std::string id = key.toStdString();
      return few ? !map_.find(id) && !findLandmark(map_, id) : !ids.contains(id);
    });
  }
  keys.removeDuplicates();
  if (keys == selection_) return;
  selection_ = std::move(keys);
  finishMerging();
  Q_EMIT selectionChanged();
}

void MapDocument::selectAll() { setSelection(allKeys(map_)); }

QString MapDocument::addBuilding(Building building) {
  building.id = freeId('B', building.id);
  QString id = QString::fromStdString(building.id);
  push({toggleItems(&Map::buildings, {{map_.buildings.size(), std::move(building)}}, false)},
       tr("Add Building %1").arg(id));
  return id;
}

QString MapDocument::addLandmark(Landmark landmark) {
  landmark.id = freeId('L', landmark.id);
  QString id = QString::fromStdString(landmark.id);
  push({toggleItems(&Map::landmarks, {{map_.landmarks.size(), std::move(landmark)}}, false)},
       tr("Add Landmark %1").arg(id));
  return id;
}

QStringList MapDocument::add(MapChange objects, const QString& text) {
  std::vector<Toggle> toggles;
  QStringList keys;
  std::unordered_set<std::string> taken;
  for (const std::string_view id : takenIds()) taken.emplace(id);
  const auto add_all = [&]<typename Item>(std::vector<Item> Map::*list, std::vector<Item>& items,
                                          char prefix) {
    Placed<Item> placed;
    int number = 1;
    for (Item& item : items) {
      while (taken.contains(item.id)) item.id = prefix + std::to_string(number++);
      taken.insert(item.id);
      keys << QString::fromStdString(item.id);
      placed.emplace_back((map_.*list).size() + placed.size(), std::move(item));
    }
    if (!placed.empty()) toggles.push_back(toggleItems(list, std::move(placed), false));
  };
  add_all(&Map::buildings, objects.buildings, 'B');
  add_all(&Map::landmarks, objects.landmarks, 'L');
  if (objects.start && !map_.start) {
    keys << kStartKey;
    toggles.push_back(swapMember(&Map::start, objects.start));
  }
  if (objects.route && !objects.route->empty() && map_.route.empty()) {
    keys << kRouteKey;
    toggles.push_back(swapMember(&Map::route, *objects.route));
  }
  push(std::move(toggles), text);
  return keys;
}

void MapDocument::apply(const MapChange& change, const QString& text, bool mergeable) {
  std::vector<Toggle> toggles;
  QString key = text + u' ';
  if (auto items = differing(change.buildings, map_.buildings); !items.empty()) {
    for (auto& [place, building] : items)
      if (building.shape != map_.buildings[place].shape) forgetFindings(building);
    key += mergeMark('b', items);
    toggles.push_back(swapItems(&Map::buildings, std::move(items)));
  }
  if (auto items = differing(change.landmarks, map_.landmarks); !items.empty()) {
    key += mergeMark('l', items);
    toggles.push_back(swapItems(&Map::landmarks, std::move(items)));
  }
  if (change.start && change.start != map_.start) {
    key += kStartKey;
    toggles.push_back(swapMember(&Map::start, change.start));
  }
  if (change.route && change.route != map_.route) {
    key += kRouteKey;
    toggles.push_back(swapMember(&Map::route, *change.route));
  }
  if (change.underlays && change.underlays != map_.underlays) {
    key += u'u';
    toggles.push_back(swapMember(&Map::underlays, *change.underlays));
  }
  push(std::move(toggles), text, mergeable ? key : QString());
}

void MapDocument::changeBuilding(const QString& id, Building building, const QString& text,
                                 bool mergeable) {
  building.id = id.toStdString();
  apply({.buildings = {std::move(building)}}, text, mergeable);
}

void MapDocument::changeLandmark(const QString& id, Landmark landmark, const QString& text,
                                 bool mergeable) {
  landmark.id = id.toStdString();
  apply({.landmarks = {std::move(landmark)}}, text, mergeable);
}

bool MapDocument::rename(const QString& id, const QString& new_id) {
  const QString wanted = new_id.trimmed();
  const QStringList taken = allKeys(map_);
  if (wanted.isEmpty() || wanted == kStartKey || wanted == kRouteKey || pictureIndex(wanted) ||
      taken.contains(wanted) || !taken.contains(id))
    return false;
  const auto renamed = [&]<typename Item>(std::vector<Item> Map::*list) {
    Placed<Item> items = chosen(map_.*list, {id});
    for (auto& entry : items) entry.second.id = wanted.toStdString();
    Toggle renaming = swapItems(list, std::move(items));
    renaming.touched = renaming.touched.anyBuilding() ? Touched{.listed = true} : renaming.touched;
    return renaming;
  };
  QStringList selected = selection_;
  std::ranges::replace(selected, id, wanted);
  push({renamed(&Map::buildings), renamed(&Map::landmarks)}, tr("Rename %1").arg(id));
  setSelection(selected);
  return true;
}

void MapDocument::removeSelected() {
  const QStringList keys = unlocked(map_, selection_);
  if (!keys.isEmpty()) remove(keys);
}

void MapDocument::remove(const QStringList& objects) {
  const QSet<QString> keys(objects.begin(), objects.end());
  std::vector<Toggle> toggles;
  if (auto items = chosen(map_.buildings, keys); !items.empty())
    toggles.push_back(toggleItems(&Map::buildings, std::move(items), true));
  if (auto items = chosen(map_.landmarks, keys); !items.empty())
    toggles.push_back(toggleItems(&Map::landmarks, std::move(items), true));
  if (keys.contains(kStartKey)) toggles.push_back(swapMember(&Map::start, {}));
  if (keys.contains(kRouteKey)) toggles.push_back(swapMember(&Map::route, {}));
  const QString what = keys.size() == 1 ? handmap::displayName(map_, objects.first())
                                        : tr("%1 Objects").arg(keys.size());
  if (auto items = chosenPictures(map_.underlays, keys); !items.empty()) {
    toggles.push_back(toggleItems(&Map::underlays, std::move(items), true));
    setSelection({});  // the keys of pictures are their places: they would name others
  }
  push(std::move(toggles), tr("Delete %1").arg(what));
}

void MapDocument::setStart(std::optional<Pose2> start, bool mergeable) {
  setMember(&Map::start, start, tr("Set Start"), mergeable);
}

void MapDocument::setStartUncertainty(const std::optional<StartUncertainty>& uncertainty,
                                      bool mergeable) {
  setMember(&Map::start_uncertainty, uncertainty, tr("Change Uncertainty"), mergeable);
}

void MapDocument::setRoute(std::vector<Vec2> route, bool mergeable) {
  setMember(&Map::route, std::move(route), tr("Change Route"), mergeable);
}

void MapDocument::setName(const QString& name, bool mergeable) {
  setMember(&Map::name, name.toStdString(), tr("Name Map"), mergeable);
}

void MapDocument::setUncertainty(Uncertainty uncertainty, bool mergeable) {
  setMember(&Map::uncertainty, uncertainty, tr("Change Uncertainty"), mergeable);
}

void MapDocument::setWholeUncertainty(WholeUncertainty whole, bool mergeable) {
  setMember(&Map::whole, whole, tr("Change Uncertainty"), mergeable);
}

QString MapDocument::addUnderlay(Underlay underlay,
                                 const std::optional<Georeference>& georeference) {
  const std::size_t place = map_.underlays.size();
  const QString name = QFileInfo(QString::fromStdString(underlay.image)).fileName();
  std::vector<Toggle> toggles{toggleItems(&Map::underlays, {{place, std::move(underlay)}}, false)};
  if (georeference) toggles.push_back(swapMember(&Map::georeference, georeference));
  push(std::move(toggles), tr("Add Picture %1").arg(name));
  return pictureKey(place);
}

void MapDocument::setUnderlays(std::vector<Underlay> underlays, const QString& text,
                               bool mergeable) {
  setMember(&Map::underlays, std::move(underlays), text, mergeable);
}

void MapDocument::setLayers(const LayerStates& layers, const QString& text, bool mergeable) {
  setMember(&Map::layers, layers, text, mergeable);
}

void MapDocument::setGeoreference(std::optional<Georeference> georeference, bool mergeable) {
  setMember(&Map::georeference, std::move(georeference), tr("Georeference"), mergeable);
}

template <typename Value>
void MapDocument::setMember(Value Map::*member, Value value, const QString& text, bool mergeable) {
  if (value == map_.*member) return;
  push({swapMember(member, std::move(value))}, text, mergeable ? text : QString());
}

bool MapDocument::acceptRefinement(const Map& refined, const QStringList& kept) {
  const QSet<QString> keep(kept.begin(), kept.end());
  std::vector<Building> accepted;
  const auto places = placesOf(map_.buildings);
  for (const Building& building : refined.buildings) {
    const auto place = places.find(building.id);
    if (place == places.end() || keep.contains(QString::fromStdString(building.id))) continue;
    accepted.push_back(corrected(map_.buildings[place->second], building));
  }
  auto differing_ones = differing(accepted, map_.buildings);
  if (differing_ones.empty() && map_.refinement == refined.refinement) return false;
  push({swapItems(&Map::buildings, std::move(differing_ones)),
        swapMember(&Map::refinement, refined.refinement)},
       tr("Accept Correction"));
  return true;
}

QStringList MapDocument::editedSince(const Map& before) const {
  QStringList edited;
  const auto places = placesOf(before.buildings);
  for (const Building& building : map_.buildings) {
    const auto place = places.find(building.id);
    // A shape that nobody has touched since a run corrected it still has its estimate.
    if (place != places.end() && !building.estimate &&
        building.shape != before.buildings[place->second].shape)
      edited << QString::fromStdString(building.id);
  }
  return edited;
}

void MapDocument::followInIndex(const std::vector<std::size_t>& places) {
  constexpr std::size_t kMostLoose = 64;  // few beside those that a search finds in its cells
  if (!building_index_) return;
  if (building_index_->loosened() + places.size() > kMostLoose) return building_index_.reset();
  for (const std::size_t place : places)
    building_index_->set(place, handmap::boundsOf(map_.buildings[place]));
}

void MapDocument::onIndexChanged() {
  Touched touched = std::exchange(touched_, {});
  if (touched.listed) {
    touched.buildings.clear();
    building_index_.reset();
    setSelection(selection_);  // drops what is gone
  } else {
    std::ranges::sort(touched.buildings);
    const auto last = std::unique(touched.buildings.begin(), touched.buildings.end());
    touched.buildings.erase(last, touched.buildings.end());
    followInIndex(touched.buildings);
    if (touched.landmarks || touched.start || touched.route || touched.underlays)
      setSelection(selection_);
  }
  Q_EMIT mapChanged(touched);
  if (file_path_.isEmpty()) Q_EMIT fileChanged();  // the name of the map may be the display name
}

void MapDocument::push(std::vector<Toggle> toggles, const QString& text, const QString& merge_key) {
  if (toggles.empty()) return;
  const QString key =
      merge_key.isEmpty() ? merge_key : QStringLiteral("%1 #%2").arg(merge_key).arg(merge_run_);
  undo_stack_.push(new Command(*this, std::move(toggles), text, key));
}

std::unordered_set<std::string_view> MapDocument::takenIds() const {
  std::unordered_set<std::string_view> taken{"", "@start", "@route"};
  taken.reserve(map_.buildings.size() + map_.landmarks.size() + 3);
  for (const Building& building : map_.buildings) taken.insert(building.id);
  for (const Landmark& landmark : map_.landmarks) taken.insert(landmark.id);
  return taken;
}

std::string MapDocument::freeId(char prefix, const std::string& wanted) const {
  const std::unordered_set<std::string_view> taken = takenIds();
  std::string id = wanted;
  for (int n = 1; taken.contains(id); ++n) id = prefix + std::to_string(n);
  return id;
}

}  // namespace handmap
