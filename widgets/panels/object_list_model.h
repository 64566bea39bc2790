// Everything drawn, one row each: the start and the route, the buildings, the landmarks, the
// pictures. Names, what is shown and what is locked can be edited.
#pragma once

#include <QAbstractTableModel>
#include <QIcon>
#include <vector>

#include "widgets/document/map_document.h"

namespace handmap {

class ObjectListModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Roles { KeyRole = Qt::UserRole };
  enum Column { NameColumn, ShownColumn, LockedColumn, Columns };

  explicit ObjectListModel(MapDocument& document, QObject* parent = nullptr);

  /// Keeps the rows, and with them scrolling and selection, when only their texts are others.
  void rebuild();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  enum class Kind { Start, Route, Box, Outline, Place, Picture };
  struct Row {
    QString key;
    QString text;
    QString name;
    Kind kind;
    bool hidden = false;
    bool locked = false;
  };
  std::vector<Row> rowsOfMap() const;
  bool rename(const Row& row, const QString& name);
  bool setFlag(const Row& row, Column column, bool on);

  MapDocument& document_;
  std::vector<Row> rows_;
  std::vector<QIcon> icons_;
};

}  // namespace handmap
