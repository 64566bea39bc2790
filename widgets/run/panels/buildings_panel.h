// The table of the refined buildings: sorted as one likes, in step with what is selected, copied as
// CSV.
#pragma once

#include <QWidget>

#include "widgets/run/panels/buildings_model.h"

class QSortFilterProxyModel;
class QTableView;

namespace handmap {

class BuildingsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit BuildingsPanel(QWidget* parent = nullptr);

  BuildingsModel& model() { return *model_; }
  QTableView& table() { return *table_; }

  /// The rows of these buildings; says nothing of it.
  void select(const QStringList& ids);
  /// As it is sorted, with a line of titles; fields with commas or quotes are quoted.
  QString csv() const;

 Q_SIGNALS:
  void selectionChanged(const QStringList& ids);
  /// Enter, or a double click.
  void showRequested(const QString& id);

 private:
  void makeTable();
  void makeActions();
  void tellSelection();
  QString idOf(const QModelIndex& shown) const;

  BuildingsModel* model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  QStringList selected_;
  bool selecting_ = false;
};

}  // namespace handmap
