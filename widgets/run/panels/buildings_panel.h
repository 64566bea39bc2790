// The review of what a run has corrected: a table of the buildings, the suspicious first, beside
// the canvas that shows each before and after; which of them are taken over is ticked. Sorted as
// one likes, in step with what is selected, copied as CSV.
#pragma once

#include <QWidget>

#include "widgets/run/panels/buildings_model.h"

class QAction;
class QPushButton;
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
  void acceptRequested();

 private:
  void makeTable();
  void makeActions();
  QWidget* makeButtons();
  void showCount();
  void hideColumns();
  void tellSelection();
  QString idOf(const QModelIndex& shown) const;

  BuildingsModel* model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  QAction* details_;
  QPushButton* accept_;
  QStringList selected_;
  bool selecting_ = false;
};

}  // namespace handmap
