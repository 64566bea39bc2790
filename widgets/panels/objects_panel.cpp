#include "widgets/panels/objects_panel.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "widgets/panels/object_tree_model.h"

namespace handmap {

ObjectsPanel::ObjectsPanel(MapDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new ObjectTreeModel(document, this)),
      filter_(new QSortFilterProxyModel(this)),
      tree_(new QTreeView) {
  filter_->setSourceModel(model_);
  filter_->setRecursiveFilteringEnabled(true);
  filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  tree_->setModel(filter_);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  tree_->setUniformRowHeights(true);
  tree_->setAccessibleName(tr("Objects of the drawing"));
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(ObjectTreeModel::NameColumn, QHeaderView::Stretch);
  for (const int column : {ObjectTreeModel::ShownColumn, ObjectTreeModel::LockedColumn}) {
    tree_->header()->setSectionResizeMode(column, QHeaderView::Fixed);
    tree_->header()->resizeSection(
        column, fontMetrics().horizontalAdvance(
                    model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()) +
                    20);
  }
  tree_->setFrameShape(QFrame::NoFrame);

  auto* search = new QLineEdit;
  search->setPlaceholderText(tr("Find by id or name"));
  search->setAccessibleName(tr("Find by id or name"));
  search->setClearButtonEnabled(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 0);
  layout->addWidget(search);
  layout->addWidget(tree_);

  connect(search, &QLineEdit::textChanged, this, [this](const QString& text) {
    syncing_ = true;  // what the filter hides stays selected
    filter_->setFilterFixedString(text);
    expandNodes();
    syncing_ = false;
    showSelection();
  });
  connect(tree_, &QTreeView::collapsed, this, [this](const QModelIndex& node) {
    if (!syncing_) collapsed_.insert(node.data(ObjectTreeModel::NodeRole).toInt());
  });
  connect(tree_, &QTreeView::expanded, this, [this](const QModelIndex& node) {
    if (!syncing_) collapsed_.remove(node.data(ObjectTreeModel::NodeRole).toInt());
  });
  connect(&document_, &MapDocument::mapChanged, this, &ObjectsPanel::follow);
  connect(&document_, &MapDocument::selectionChanged, this, &ObjectsPanel::showSelection);
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &ObjectsPanel::selectFromTree);
  connect(tree_, &QTreeView::activated, this, [this](const QModelIndex& index) {
    const QString key = index.data(ObjectTreeModel::KeyRole).toString();
    if (!key.isEmpty()) Q_EMIT showRequested(key);
  });
  expandNodes();
}

/// What was open and where the keyboard was stays.
void ObjectsPanel::follow(const Touched& touched) {
  const QString current = tree_->currentIndex().data(ObjectTreeModel::KeyRole).toString();
  syncing_ = true;
  model_->follow(touched);
  expandNodes();
  const QModelIndex again = filter_->mapFromSource(model_->indexOf(current));
  if (again.isValid() && again != tree_->currentIndex()) {
    tree_->selectionModel()->setCurrentIndex(again, QItemSelectionModel::NoUpdate);
  }
  syncing_ = false;
  showSelection();
}

void ObjectsPanel::expandNodes() {
  for (int row = 0; row < filter_->rowCount(); ++row) {
    const QModelIndex node = filter_->index(row, 0);
    tree_->setExpanded(node, !collapsed_.contains(node.data(ObjectTreeModel::NodeRole).toInt()));
  }
}

void ObjectsPanel::selectFromTree() {
  if (syncing_) return;
  QStringList keys;
  for (const QModelIndex& index : tree_->selectionModel()->selectedRows()) {
    keys << model_->keysUnder(filter_->mapToSource(index));
  }
  keys.removeDuplicates();
  syncing_ = true;
  document_.setSelection(keys);
  syncing_ = false;
}

void ObjectsPanel::showSelection() {
  if (syncing_) return;
  syncing_ = true;
  std::vector<QModelIndex> chosen;
  for (const QString& key : document_.selection()) {
    const QModelIndex index = filter_->mapFromSource(model_->indexOf(key));
    if (index.isValid()) chosen.push_back(index);
  }
  std::sort(chosen.begin(), chosen.end());
  QItemSelection selection;  // of ranges: many single rows would take long
  for (std::size_t first = 0; first < chosen.size();) {
    std::size_t last = first;
    while (last + 1 < chosen.size() && chosen[last + 1].parent() == chosen[first].parent() &&
           chosen[last + 1].row() == chosen[last].row() + 1) {
      ++last;
    }
    selection.select(chosen[first], chosen[last]);
    first = last + 1;
  }
  tree_->selectionModel()->select(selection,
                                  QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  if (chosen.size() == 1) tree_->scrollTo(chosen.front());
  syncing_ = false;
}

}  // namespace handmap
