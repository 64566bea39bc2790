#include "widgets/actions/keys_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include "widgets/actions/action_set.h"

namespace handmap {

namespace {
enum Column { NameColumn, KeysColumn, HintColumn, Columns };
}  // namespace

KeysPanel::KeysPanel(const ActionSet& actions, QWidget* parent)
    : QWidget(parent),
      actions_(actions),
      tree_(new QTreeWidget),
      search_(new QLineEdit),
      edit_(new QKeySequenceEdit),
      usual_(new QPushButton(tr("Reset"))),
      all_usual_(new QPushButton(tr("Reset All"))),
      clash_(new QLabel),
      take_(new QPushButton(tr("Use it here"))) {
  tree_->setObjectName(QStringLiteral("keys"));
  tree_->setAccessibleName(tr("Commands and their keys"));
  tree_->setColumnCount(Columns);
  tree_->setHeaderLabels({tr("Command"), tr("Keys"), tr("What it does")});
  tree_->setRootIsDecorated(false);
  tree_->setUniformRowHeights(true);
  search_->setPlaceholderText(tr("Find a command or key"));
  search_->setAccessibleName(tr("Find a command or key"));
  search_->setClearButtonEnabled(true);
  edit_->setObjectName(QStringLiteral("edit_keys"));
  edit_->setAccessibleName(tr("New keys"));
  usual_->setObjectName(QStringLiteral("usual_keys"));
  all_usual_->setObjectName(QStringLiteral("all_usual_keys"));
  clash_->setObjectName(QStringLiteral("clash"));
  clash_->setWordWrap(true);
  take_->setObjectName(QStringLiteral("take_keys"));
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Keys:")));
  row->addWidget(edit_, 1);
  row->addWidget(usual_);
  row->addWidget(all_usual_);
  auto* clash_row = new QHBoxLayout;
  clash_row->addWidget(clash_, 1);
  clash_row->addWidget(take_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(search_);
  layout->addWidget(tree_, 1);
  layout->addLayout(row);
  layout->addLayout(clash_row);
  connect(search_, &QLineEdit::textChanged, this, &KeysPanel::filter);
  connect(tree_, &QTreeWidget::currentItemChanged, this, &KeysPanel::choose);
  connect(tree_, &QTreeWidget::itemActivated, edit_, qOverload<>(&QWidget::setFocus));
  connect(edit_, &QKeySequenceEdit::editingFinished, this, [this] { apply(false); });
  connect(take_, &QPushButton::clicked, this, [this] { apply(true); });
  connect(usual_, &QPushButton::clicked, this, [this] { reset(false); });
  connect(all_usual_, &QPushButton::clicked, this, [this] { reset(true); });
  fill();
  choose();
}

void KeysPanel::fill() {
  QTreeWidgetItem* group = nullptr;
  const ActionSpec* before = nullptr;
  for (const ActionSpec& spec : actionTable()) {
    if (!before || before->menu != spec.menu) {
      group = new QTreeWidgetItem(tree_, {plainTitleOf(spec.menu)});
      group->setFlags(Qt::ItemIsEnabled);
      group->setExpanded(true);
      QFont bold = font();
      bold.setBold(true);
      group->setFont(NameColumn, bold);
    }
    before = &spec;
    auto* item = new QTreeWidgetItem(group, {plainTextOf(spec), {}, hintOf(spec)});
    item->setData(NameColumn, Qt::UserRole, QLatin1String(spec.id));
    item->setToolTip(HintColumn, hintOf(spec));
  }
  showKeys();
  tree_->resizeColumnToContents(NameColumn);
  tree_->resizeColumnToContents(KeysColumn);
}

void KeysPanel::showKeys() {
  for (QTreeWidgetItemIterator it(tree_); *it; ++it) {
    const QString id = (*it)->data(NameColumn, Qt::UserRole).toString();
    if (id.isEmpty()) continue;
    (*it)->setText(KeysColumn,
                   QKeySequence::listToString(actions_.keys(id), QKeySequence::NativeText));
  }
}

void KeysPanel::filter(const QString& text) {
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = tree_->topLevelItem(i);
    bool any = false;
    for (int j = 0; j < group->childCount(); ++j) {
      QTreeWidgetItem* item = group->child(j);
      const bool matches = item->text(NameColumn).contains(text, Qt::CaseInsensitive) ||
                           item->text(KeysColumn).contains(text, Qt::CaseInsensitive);
      item->setHidden(!matches);
      any = any || matches;
    }
    group->setHidden(!any);
  }
}

QString KeysPanel::chosen() const {
  const QTreeWidgetItem* item = tree_->currentItem();
  return item ? item->data(NameColumn, Qt::UserRole).toString() : QString();
}

void KeysPanel::choose() {
  const QString id = chosen();
  edit_->setEnabled(!id.isEmpty());
  usual_->setEnabled(!id.isEmpty());
  edit_->setKeySequence(id.isEmpty() ? QKeySequence() : actions_.keys(id).value(0));
  clash_->clear();
  take_->hide();
}

void KeysPanel::apply(bool take_from_others) {
  const QString id = chosen();
  if (id.isEmpty()) return;
  QList<QKeySequence> keys;
  if (!edit_->keySequence().isEmpty()) keys << edit_->keySequence();
  if (keys.value(0) == actions_.keys(id).value(0)) return choose();
  const QString owner = actions_.ownerOf(keys, id);
  if (!owner.isEmpty() && !take_from_others) {
    clash_->setText(tr("“%1” already means “%2”.")
                        .arg(keys.first().toString(QKeySequence::NativeText),
                             actions_[owner].toolTip().section(u'\n', 0, 0)));
    take_->show();
    return;
  }
  if (!owner.isEmpty()) {
    QList<QKeySequence> left = actions_.keys(owner);
    left.removeAll(keys.first());
    actions_.setKeys(owner, left);
  }
  actions_.setKeys(id, keys);
  showKeys();
  choose();
  Q_EMIT keysChanged();
}

/// Keys that somebody has given to another action since go back to where they belong.
void KeysPanel::reset(bool all) {
  const QString id = chosen();
  for (const ActionSpec& spec : actionTable()) {
    const QString its = QLatin1String(spec.id);
    if (!all && its != id) continue;
    const QList<QKeySequence> usual = ActionSet::usualKeys(spec);
    for (QString owner = actions_.ownerOf(usual, its); !owner.isEmpty();
         owner = actions_.ownerOf(usual, its)) {
      QList<QKeySequence> left = actions_.keys(owner);
      left.removeIf([&](const QKeySequence& keys) { return usual.contains(keys); });
      actions_.setKeys(owner, left);
    }
    actions_.setKeys(its, usual);
  }
  showKeys();
  choose();
  Q_EMIT keysChanged();
}

}  // namespace handmap
