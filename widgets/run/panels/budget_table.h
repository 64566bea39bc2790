// The profile of the frame budget: the share of each stage, its median and its 95th percentile,
// against the time between two frames. The legend of the stages too.
#pragma once

#include <QWidget>

#include "widgets/run/panels/frame_budget.h"

class QLabel;

namespace handmap {

/// The colour of a stage is that of text, its pattern its own.
QBrush stageBrush(std::size_t stage, const QPalette& palette);

class BudgetTable : public QWidget {
  Q_OBJECT
 public:
  explicit BudgetTable(QWidget* parent = nullptr);

  void setBudget(const FrameBudget& budget);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void paintSamples();

  struct Row {
    QLabel* sample;
    QLabel* name;
    QLabel* share;
    QLabel* p50;
    QLabel* p95;
  };
  std::array<Row, kStages.size() + 1> rows_;  ///< the last: all
  QLabel* verdict_;
};

}  // namespace handmap
