#include "widgets/run/panels/buildings_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSet>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

namespace handmap {

namespace {

constexpr int kWidestColumn = 190;  // pixels; the rest is in the tooltip
constexpr int kCsvRole = BuildingsModel::kCsvRole;

QString csvField(QString text) {
  text.replace(QLatin1Char('\n'), QLatin1Char(' '));
  const bool plain = !text.contains(QLatin1Char(',')) && !text.contains(QLatin1Char('"'));
  if (plain) return text;
  return QLatin1Char('"') + text.replace(QStringLiteral("\""), QStringLiteral("\"\"")) +
         QLatin1Char('"');
}

}  // namespace

BuildingsPanel::BuildingsPanel(QWidget* parent)
    : QWidget(parent),
      model_(new BuildingsModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      table_(new QTableView),
      details_(new QAction(tr("&All figures"), this)),
      accept_(new QPushButton) {
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(BuildingsModel::kSortRole);
  makeTable();
  makeActions();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(table_);
  layout->addWidget(makeButtons());
}

QWidget* BuildingsPanel::makeButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(4, 4, 4, 4);
  const auto add_button = [&](const QString& text, bool taken) {
    auto* button = new QPushButton(text);
    layout->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, taken] { model_->setAllTaken(taken); });
  };
  add_button(tr("All"), true);
  add_button(tr("None"), false);
  layout->addStretch();
  layout->addWidget(accept_);
  accept_->setObjectName("accept_ticked");
  connect(accept_, &QPushButton::clicked, this, &BuildingsPanel::acceptRequested);
  connect(model_, &BuildingsModel::takenChanged, this, &BuildingsPanel::showCount);
  connect(model_, &QAbstractItemModel::modelReset, this, &BuildingsPanel::showCount);
  showCount();
  return row;
}

void BuildingsPanel::showCount() {
  const int all = model_->rowCount();
  const auto taken = all - static_cast<int>(model_->leftOut().size());
  accept_->setText(tr("Accept %1 of %2").arg(taken).arg(all));
  accept_->setEnabled(taken > 0);
}

void BuildingsPanel::hideColumns() {
  for (int column = BuildingsModel::FirstDetail; column < BuildingsModel::ColumnCount; ++column) {
    const bool known = column != BuildingsModel::Error || model_->hasTruth();
    table_->setColumnHidden(column, !known || !details_->isChecked());
  }
}

void BuildingsPanel::makeTable() {
  table_->setModel(sorted_);
  table_->setAccessibleName(tr("Corrected buildings"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setAlternatingRowColors(true);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  table_->setSortingEnabled(true);
  table_->sortByColumn(BuildingsModel::Why, Qt::DescendingOrder);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setMinimumSectionSize(0);
  table_->horizontalHeader()->setMaximumSectionSize(kWidestColumn);
  // What a narrow panel shows: the building, how far it moved, and why that is doubtful.
  table_->horizontalHeader()->moveSection(BuildingsModel::Why, BuildingsModel::Turned);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.85);
  table_->setFont(small);
  table_->horizontalHeader()->setFont(small);
  hideColumns();
  connect(model_, &QAbstractItemModel::modelReset, this, [this] {
    hideColumns();
    select(selected_);
  });
  connect(table_, &QTableView::activated, this,
          [this](const QModelIndex& index) { Q_EMIT showRequested(idOf(index)); });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &BuildingsPanel::tellSelection);
}

void BuildingsPanel::makeActions() {
  auto* copy = new QAction(tr("&Copy as CSV"), this);
  copy->setShortcut(QKeySequence::Copy);
  copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  connect(copy, &QAction::triggered, this,
          [this] { QGuiApplication::clipboard()->setText(csv()); });
  table_->addAction(copy);
  details_->setCheckable(true);
  connect(details_, &QAction::toggled, this, &BuildingsPanel::hideColumns);
  table_->addAction(details_);
  table_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

QString BuildingsPanel::idOf(const QModelIndex& shown) const {
  return model_->idAt(sorted_->mapToSource(shown).row());
}

void BuildingsPanel::tellSelection() {
  if (selecting_) return;
  selected_.clear();
  for (const QModelIndex& index : table_->selectionModel()->selectedRows()) {
    selected_ << idOf(index);
  }
  Q_EMIT selectionChanged(selected_);
}

void BuildingsPanel::select(const QStringList& ids) {
  const QScopedValueRollback quiet(selecting_, true);
  selected_ = ids;
  const QSet<QString> wanted(ids.begin(), ids.end());
  const auto is_wanted = [&](int row) {
    return row < sorted_->rowCount() && wanted.contains(idOf(sorted_->index(row, 0)));
  };
  QItemSelection rows;  // of ranges: many single rows would take long
  for (int row = 0; row < sorted_->rowCount(); ++row) {
    if (!is_wanted(row)) continue;
    const int first = row;
    while (is_wanted(row + 1)) ++row;
    rows.select(sorted_->index(first, 0), sorted_->index(row, 0));
  }
  table_->selectionModel()->select(rows,
                                   QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  if (!rows.isEmpty()) table_->scrollTo(rows.first().topLeft());
}

QString BuildingsPanel::csv() const {
  QString text;
  for (int row = -1; row < sorted_->rowCount(); ++row) {
    QStringList fields;
    for (int column = 0; column < sorted_->columnCount(); ++column) {
      if (column == BuildingsModel::Error && !model_->hasTruth()) continue;
      fields << csvField(row < 0 ? sorted_->headerData(column, Qt::Horizontal).toString()
                                 : sorted_->index(row, column).data(kCsvRole).toString());
    }
    text += fields.join(QLatin1Char(',')) + QLatin1Char('\n');
  }
  return text;
}

}  // namespace handmap
