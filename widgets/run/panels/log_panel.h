// The log of a run: filtered by words and by how bad it is, copied as text. A row leads to its
// building and to its time.
#pragma once

#include <QWidget>

#include "widgets/run/panels/log_model.h"

class QComboBox;
class QLineEdit;
class QSortFilterProxyModel;
class QTableView;

namespace handmap {

class LogPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LogPanel(QWidget* parent = nullptr);

  LogModel& model() { return *model_; }
  /// The selected rows, or all that are shown where none is.
  QString text() const;

 Q_SIGNALS:
  void timeChosen(double time_s);
  void showRequested(const QString& building);

 private:
  class Filter;

  void makeTable();
  void activate(const QModelIndex& shown);

  LogModel* model_;
  Filter* filter_;
  QLineEdit* words_;
  QComboBox* kinds_;
  QTableView* table_;
};

}  // namespace handmap
