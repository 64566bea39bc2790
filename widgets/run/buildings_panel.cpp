#include "widgets/run/buildings_panel.h"

#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

namespace handmap {

BuildingsPanel::BuildingsPanel(QWidget* parent)
    : QWidget(parent), model_(new BuildingsModel(this)) {
  auto* table = new QTableView;
  table->setAccessibleName(tr("Buildings of the run"));
  table->setModel(model_);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setAlternatingRowColors(true);
  table->setFrameShape(QFrame::NoFrame);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setMinimumSectionSize(0);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.85);
  table->setFont(small);
  table->horizontalHeader()->setFont(small);
  connect(table, &QTableView::activated, this,
          [this](const QModelIndex& index) { Q_EMIT showRequested(model_->idAt(index.row())); });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(table);
}

}  // namespace handmap
