// The buildings of a run: as drawn, as corrected, how sure each is and why it is doubtful; and
// which of them are to be taken over. For a sorting proxy: the sort role gives numbers.
#pragma once

#include <QAbstractTableModel>
#include <QHash>
#include <optional>
#include <vector>

#include "core/map/concerns.h"
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
    Wider,
    Deeper,
    Sure,
    Why,
    FirstDetail,  ///< from here on: figures that few ask for
    Doubt = FirstDetail,
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
  /// Those that the person does not take: the ticked ones are all others. What is rather wrong than
  /// right is not ticked at first.
  QStringList leftOut() const;
  void setAllTaken(bool taken);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 Q_SIGNALS:
  void takenChanged();

 private:
  struct Row {
    QString id;
    QString name;
    std::size_t building = 0;  ///< of the drawing
    /// By column; none of Name. NaN: not known.
    std::array<double, ColumnCount> numbers{};
    std::array<bool, 4> seen{};  ///< by the columns of the sigmas
    QString why;
    bool doubtful = false;
  };
  bool isTaken(const Row& row) const { return taken_.value(row.id, !row.doubtful); }
  Row rowOf(std::size_t building, const Building& now) const;
  QString words(const Row& row) const;
  QString text(const Row& row, int column) const;
  static QString csvText(const Row& row, int column);

  Map drawing_;
  std::optional<TrueMiddles> truth_;
  Map refined_;
  std::vector<Concern> concerns_;  ///< of `refined_`
  std::vector<Row> rows_;
  QHash<QString, bool> taken_;  ///< as the person said
};

}  // namespace handmap
