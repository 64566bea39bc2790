#include "widgets/panels/objects_panel.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QSet>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>

#include "widgets/panels/object_list_model.h"

namespace handmap {

ObjectsPanel::ObjectsPanel(MapDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new ObjectListModel(document, this)),
      filter_(new QSortFilterProxyModel(this)),
      list_(new QTreeView) {
  filter_->setSourceModel(model_);
  filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  list_->setModel(filter_);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list_->setUniformRowHeights(true);
  list_->setRootIsDecorated(false);
  list_->setAccessibleName(tr("Objects of the drawing"));
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(ObjectListModel::NameColumn, QHeaderView::Stretch);
  for (const int column : {ObjectListModel::ShownColumn, ObjectListModel::LockedColumn}) {
    list_->header()->setSectionResizeMode(column, QHeaderView::Fixed);
    list_->header()->resizeSection(
        column, fontMetrics().horizontalAdvance(
                    model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()) +
                    20);
  }
  list_->setFrameShape(QFrame::NoFrame);

  auto* search = new QLineEdit;
  search->setPlaceholderText(tr("Find by id or name"));
  search->setAccessibleName(tr("Find by id or name"));
  search->setClearButtonEnabled(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 0);
  layout->addWidget(search);
  layout->addWidget(list_);

  connect(search, &QLineEdit::textChanged, this, [this](const QString& text) {
    syncing_ = true;  // what the filter hides stays selected
    filter_->setFilterFixedString(text);
    syncing_ = false;
    showSelection();
  });
  connect(&document_, &MapDocument::mapChanged, this, [this] {
    syncing_ = true;
    model_->rebuild();
    syncing_ = false;
    showSelection();
  });
  connect(&document_, &MapDocument::selectionChanged, this, &ObjectsPanel::showSelection);
  connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &ObjectsPanel::selectFromList);
  connect(list_, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
    Q_EMIT showRequested(index.data(ObjectListModel::KeyRole).toString());
  });
}

void ObjectsPanel::selectFromList() {
  if (syncing_) return;
  QStringList keys;
  for (const QModelIndex& index : list_->selectionModel()->selectedRows())
    keys << index.data(ObjectListModel::KeyRole).toString();
  syncing_ = true;
  document_.setSelection(keys);
  syncing_ = false;
}

void ObjectsPanel::showSelection() {
  if (syncing_) return;
  syncing_ = true;
  const QStringList keys = document_.selection();
  const QSet<QString> wanted(keys.begin(), keys.end());
  QItemSelection selection;
  QModelIndex first;
  QModelIndex last;
  const auto close_range = [&] {
    if (first.isValid()) selection.select(first, last);
    first = {};
  };
  for (int row = 0; row < filter_->rowCount(); ++row) {
    const QModelIndex index = filter_->index(row, 0);
    if (!wanted.contains(index.data(ObjectListModel::KeyRole).toString())) {
      close_range();
      continue;
    }
    if (!first.isValid()) first = index;
    last = index;
  }
  close_range();
  list_->selectionModel()->select(selection,
                                  QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  if (keys.size() == 1 && last.isValid()) list_->scrollTo(last);
  syncing_ = false;
}

}  // namespace handmap
