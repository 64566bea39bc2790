// Everything drawn, one row each: the start and the route, the buildings, the landmarks.
#pragma once

#include <QAbstractListModel>
#include <vector>

#include "widgets/document/map_document.h"

namespace handmap {

class ObjectListModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Roles { KeyRole = Qt::UserRole };

  explicit ObjectListModel(const MapDocument& document, QObject* parent = nullptr);

  /// Keeps the rows, and with them scrolling and selection, when only their texts are others.
  void rebuild();

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  struct Row {
    QString key;
    QString text;
    int icon = 0;
  };
  std::vector<Row> rowsOfMap() const;

  const MapDocument& document_;
  std::vector<Row> rows_;
  std::vector<QIcon> icons_;
};

}  // namespace handmap
