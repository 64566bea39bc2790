// Everything drawn, as a tree: the start, the route, and under one node each the buildings, the
// landmarks and the pictures. Names, what is shown and what is locked can be edited, of an object
// and of a whole kind.
#pragma once

#include <QAbstractItemModel>
#include <QIcon>
#include <string>
#include <unordered_map>
#include <vector>

#include "widgets/document/map_document.h"

namespace handmap {

class ObjectTreeModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Roles {
    KeyRole = Qt::UserRole,  ///< empty for the node of a kind
    NodeRole                 ///< the kind, a number
  };
  enum Column { NameColumn, ShownColumn, LockedColumn, Columns };

  explicit ObjectTreeModel(MapDocument& document, QObject* parent = nullptr);

  /// Keeps the rows, and with them scrolling and selection, when only what they say is other.
  void follow(const Touched& touched);
  /// Invalid where there is no such object.
  QModelIndex indexOf(const QString& key) const;
  /// Of everything under a node, itself included.
  QStringList keysUnder(const QModelIndex& index) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  enum class Kind { Start, Route, Buildings, Landmarks, Pictures };
  /// What is in the tree; what it says is read from the document.
  struct Rows {
    std::vector<Kind> tops;
    std::vector<std::string> buildings;  ///< ids
    std::vector<std::string> landmarks;
    std::size_t pictures = 0;
    bool operator==(const Rows&) const = default;
  };
  struct State {
    bool hidden = false;
    bool locked = false;
    bool operator==(const State&) const = default;
  };
  /// What the row of a building shows beside its id.
  struct Look {
    std::string name;
    State state;
    bool is_box = true;
    bool operator==(const Look&) const = default;
  };

  Rows rowsOfMap() const;
  bool agreesWithMap() const;
  void take(Rows rows);
  void tellChangedBuildings(const QModelIndex& node, const Touched& touched);
  static Look lookOf(const Building& building);
  static bool isTop(const QModelIndex& index) { return index.internalId() == 0; }
  static DrawingLayer layerOf(Kind kind);
  Kind kindOf(const QModelIndex& index) const;
  std::size_t countOf(Kind kind) const;
  QString keyOf(const QModelIndex& index) const;
  QString nameOf(const QModelIndex& index) const;  ///< that was given
  QString textOf(const QModelIndex& index) const;
  QString titleOf(Kind kind) const;
  QString spoken(const QModelIndex& index) const;
  QIcon iconOf(const QModelIndex& index) const;
  std::optional<State> stateOf(const QModelIndex& index) const;
  bool rename(const QModelIndex& index, const QString& name);
  bool setFlag(const QModelIndex& index, bool on);
  bool setLayerFlag(Kind kind, bool is_lock, bool wanted, const QString& text);

  MapDocument& document_;
  Rows rows_;
  std::vector<Look> looks_;  ///< of the buildings, as they were last told
  std::unordered_map<std::string, std::size_t> building_rows_;  ///< by id
  std::unordered_map<std::string, std::size_t> landmark_rows_;
  QIcon start_icon_, route_icon_, box_icon_, outline_icon_, landmark_icon_, picture_icon_;
};

}  // namespace handmap
