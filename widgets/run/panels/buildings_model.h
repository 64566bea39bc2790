// The buildings of a run: as drawn, as corrected, and how sure each is. For a sorting proxy: the
// sort role gives numbers.
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "core/map/map_changes.h"

namespace handmap {

class BuildingsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  /// Metres, degrees and per cent. The sigmas are of the walls that face right, up, left and down
  /// on the map.
  enum Column {
    Name,
    Moved,
    Turned,
    Doubt,
    SigmaRight,
    SigmaUp,
    SigmaLeft,
    SigmaDown,
    Observations,
    Error,
    DrawnX,
    DrawnY,
    NowX,
    NowY,
    Wider,
    Deeper,
    ColumnCount
  };
  static constexpr int kSortRole = Qt::UserRole;
  /// Text for other programs: nothing where nothing is known, or nobody saw the wall.
  static constexpr int kCsvRole = Qt::UserRole + 1;

  using QAbstractTableModel::QAbstractTableModel;

  /// Begins anew.
  void setDrawing(Map drawing);
  /// For the column of the errors. nullopt: not known.
  void setTruth(const std::optional<TrueMiddles>& truth) { truth_ = truth; }
  bool hasTruth() const { return truth_.has_value(); }
  void setRefined(const Map& refined);
  QString idAt(int row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    QString id;
    QString name;
    std::size_t building = 0;  ///< of the drawing
    /// By column; none of Name. NaN: not known.
    std::array<double, ColumnCount> numbers{};
    std::array<bool, 4> seen{};  ///< by the columns of the sigmas
  };
  Row rowOf(std::size_t building, const Building& now) const;
  QString words(const Row& row) const;
  QString text(const Row& row, int column) const;
  static QString csvText(const Row& row, int column);

  Map drawing_;
  std::optional<TrueMiddles> truth_;
  Map refined_;
  std::vector<Row> rows_;
};

}  // namespace handmap
