// The one editable map, its undo stack and what is selected in it.
#pragma once

#include <QObject>
#include <QStringList>
#include <QUndoStack>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "core/map/map.h"
#include "core/sketching/box_index.h"
#include "widgets/document/map_change.h"
#include "widgets/document/toggle.h"

namespace handmap {

/// Every change is one command on undoStack() and ends with mapChanged(), which tells what it has
/// touched; commands hold only what they change. Units as in core/map/map.h. The caller answers for
/// finite numbers and simple, counter-clockwise polygons.
class MapDocument : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(MapDocument)
 public:
  explicit MapDocument(QObject* parent = nullptr);
  ~MapDocument() override;

  const Map& map() const { return map_; }
  /// The boxes around map().buildings, in their order.
  const BoxIndex& buildingIndex() const;
  QUndoStack& undoStack() { return undo_stack_; }

  // --- File
  QString filePath() const { return file_path_; }  ///< empty: never saved
  bool isModified() const { return !undo_stack_.isClean(); }
  QString displayName() const;  ///< the file's name, else the map's, else "Untitled"
  /// The file beside which the relative paths of map() lie. It stays when the drawing is saved in
  /// another folder, so that undo steps keep their meaning; what is saved is told anew.
  QString origin() const { return origin_; }
  /// Takes another map in place of this one; forgets undo steps and selection. An empty origin is
  /// the path.
  void reset(Map map = {}, QString path = {}, const QString& origin = {});
  void open(const QString& path);  ///< throws Error; the document is then as before
  void save(const QString& path);  ///< throws Error; atomic
  /// Names the model that belongs to this map, see core/map/references.h; `map_path` is where the
  /// map will be saved.
  void setModel(const QString& model, const QString& map_path);
  /// Whether pictures from outside of the drawing's folder are shown; not before somebody says so.
  bool trustsReferences() const { return trusts_references_; }
  void setTrustsReferences(bool trusts);

  // --- Selection: keys of objects that exist, each once
  QStringList selection() const { return selection_; }
  void setSelection(QStringList keys);
  void selectAll();  ///< but the pictures

  // --- Edits. With `mergeable`, a run of edits with the same text and objects is one undo step
  //     until finishMerging().
  /// Gives an empty or taken id the next free one, B1, B2 …; returns the id.
  QString addBuilding(Building building);
  QString addLandmark(Landmark landmark);  ///< L1, L2 …
  /// All of it in one step; ids that are taken become free ones. A start or a route that the
  /// drawing has already stays. Returns the keys of what came.
  QStringList add(MapChange objects, const QString& text);
  void changeBuilding(const QString& id, Building building, const QString& text,
                      bool mergeable = false);
  void changeLandmark(const QString& id, Landmark landmark, const QString& text,
                      bool mergeable = false);
  /// One step for objects of every kind.
  void apply(const MapChange& change, const QString& text, bool mergeable = false);
  /// False, and nothing is changed, when the id is empty, taken or one of the two special keys.
  bool rename(const QString& id, const QString& new_id);
  void removeSelected();  ///< but what is locked
  void remove(const QStringList& keys);
  void setStart(std::optional<Pose2> start, bool mergeable = false);
  /// How sure the start is; nullopt: not said.
  void setStartUncertainty(const std::optional<StartUncertainty>& uncertainty,
                           bool mergeable = false);
  void setRoute(std::vector<Vec2> route, bool mergeable = false);
  void setName(const QString& name, bool mergeable = false);
  void setUncertainty(Uncertainty uncertainty, bool mergeable = false);
  void setWholeUncertainty(WholeUncertainty whole, bool mergeable = false);
  /// On top of the others; with where the map lies, where the picture tells. Returns its key.
  QString addUnderlay(Underlay underlay, const std::optional<Georeference>& georeference = {});
  void setUnderlays(std::vector<Underlay> underlays, const QString& text, bool mergeable = false);
  void setLayers(const LayerStates& layers, const QString& text, bool mergeable = false);
  void setGeoreference(std::optional<Georeference> georeference, bool mergeable = false);
  /// Shapes, estimates and doubts of the buildings that `refined` shares with the drawing, without
  /// those of `kept`, and its "refinement" object: one undo step. False: it has them already.
  bool acceptRefinement(const Map& refined, const QStringList& kept = {});
  /// Buildings that somebody has given another shape since the drawing was `before`; what a
  /// refinement did to them does not count.
  QStringList editedSince(const Map& before) const;

  void finishMerging() { ++merge_run_; }

 Q_SIGNALS:
  void mapChanged(const Touched& touched);
  void selectionChanged();
  void fileChanged();  ///< path, display name or isModified()
  void trustChanged();

 private:
  class Command;

  void push(std::vector<Toggle> toggles, const QString& text, const QString& merge_key = {});
  template <typename Value>
  void setMember(Value Map::*member, Value value, const QString& text, bool mergeable);
  void onIndexChanged();
  void followInIndex(const std::vector<std::size_t>& places);
  std::unordered_set<std::string_view> takenIds() const;
  std::string freeId(char prefix, const std::string& wanted) const;

  Map map_;
  QUndoStack undo_stack_;
  QString file_path_;
  QString origin_;
  bool trusts_references_ = false;
  QStringList selection_;
  mutable std::optional<BoxIndex> building_index_;  ///< absent: to be made when asked for
  Touched touched_;                                 ///< since mapChanged()
  int merge_run_ = 0;
};

}  // namespace handmap
