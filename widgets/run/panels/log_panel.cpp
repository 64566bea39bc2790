#include "widgets/run/panels/log_panel.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

namespace handmap {

/// Rows that hold the words and are at least so bad.
class LogPanel::Filter : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;

  void setLeast(LogKind least) {
    least_ = least;
    invalidateFilter();
  }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const auto& log = static_cast<const LogModel&>(*sourceModel());
    return log.entry(row).kind >= least_ && QSortFilterProxyModel::filterAcceptsRow(row, parent);
  }

 private:
  LogKind least_ = LogKind::Note;
};

LogPanel::LogPanel(QWidget* parent)
    : QWidget(parent),
      model_(new LogModel(this)),
      filter_(new Filter(this)),
      words_(new QLineEdit),
      kinds_(new QComboBox),
      table_(new QTableView) {
  filter_->setSourceModel(model_);
  filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  filter_->setFilterKeyColumn(LogModel::Text);
  words_->setPlaceholderText(tr("Filter"));
  words_->setClearButtonEnabled(true);
  words_->setAccessibleName(tr("Words that the log is filtered by"));
  connect(words_, &QLineEdit::textChanged, filter_, &QSortFilterProxyModel::setFilterFixedString);
  kinds_->addItem(tr("Everything"), static_cast<int>(LogKind::Note));
  kinds_->addItem(tr("Warnings and problems"), static_cast<int>(LogKind::Warning));
  kinds_->addItem(tr("Problems"), static_cast<int>(LogKind::Problem));
  kinds_->setAccessibleName(tr("What the log shows"));
  connect(kinds_, &QComboBox::currentIndexChanged, this,
          [this] { filter_->setLeast(static_cast<LogKind>(kinds_->currentData().toInt())); });
  makeTable();
  auto* row = new QHBoxLayout;
  row->setContentsMargins(4, 4, 4, 0);
  row->addWidget(words_, 1);
  row->addWidget(kinds_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(row);
  layout->addWidget(table_, 1);
}

void LogPanel::makeTable() {
  table_->setModel(filter_);
  table_->setAccessibleName(tr("Log of the run"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setShowGrid(false);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.85);
  table_->setFont(small);
  table_->horizontalHeader()->setFont(small);
  connect(table_, &QTableView::activated, this, &LogPanel::activate);
  // The newest is in sight as long as nobody looks at older ones.
  connect(filter_, &QAbstractItemModel::rowsAboutToBeInserted, this, [this] {
    const QScrollBar* bar = table_->verticalScrollBar();
    table_->setProperty("at_end", bar->value() == bar->maximum());
  });
  connect(
      filter_, &QAbstractItemModel::rowsInserted, this,
      [this] {
        if (table_->property("at_end").toBool()) table_->scrollToBottom();
      },
      Qt::QueuedConnection);
  auto* copy = new QAction(tr("&Copy"), this);
  copy->setShortcut(QKeySequence::Copy);
  copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  connect(copy, &QAction::triggered, this,
          [this] { QGuiApplication::clipboard()->setText(text()); });
  table_->addAction(copy);
  table_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void LogPanel::activate(const QModelIndex& shown) {
  const LogEntry& entry = model_->entry(filter_->mapToSource(shown).row());
  if (entry.time_s) Q_EMIT timeChosen(*entry.time_s);
  if (!entry.building.isEmpty()) Q_EMIT showRequested(entry.building);
}

QString LogPanel::text() const {
  QList<int> rows;
  for (const QModelIndex& index : table_->selectionModel()->selectedRows()) rows << index.row();
  std::ranges::sort(rows);
  if (rows.isEmpty()) {
    for (int row = 0; row < filter_->rowCount(); ++row) rows << row;
  }
  QString text;
  for (const int row : rows) {
    QStringList fields;
    for (int column = 0; column < LogModel::ColumnCount; ++column) {
      fields << filter_->index(row, column).data().toString();
    }
    text += fields.join(QLatin1Char('\t')) + QLatin1Char('\n');
  }
  return text;
}

}  // namespace handmap
