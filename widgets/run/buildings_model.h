// The refined buildings of a run against the drawing it was given.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/map/map.h"

namespace handmap {

class BuildingsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  /// Metres; the last three are refined minus drawn.
  enum Column { Id, X, SigmaX, Width, SigmaWidth, MovedX, MovedY, Widened, ColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  /// Begins anew.
  void setDrawing(Map drawing);
  void setRefined(const Map& refined);
  QString idAt(int row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    QString id;
    std::array<double, ColumnCount> metres{};  ///< by column; none of Id
    bool operator==(const Row&) const = default;
  };

  Map drawing_;
  std::vector<Row> rows_;
};

}  // namespace handmap
