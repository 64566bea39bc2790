#include "widgets/comparing/comparison_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <array>

#include "widgets/comparing/figure_words.h"

namespace handmap {

namespace {

constexpr QSize kComparisonSize(560, 620);

}  // namespace

ComparisonDialog::ComparisonDialog(QWidget* parent)
    : QDialog(parent), words_(new QLabel), tree_(new QTreeWidget) {
  setObjectName("comparison_dialog");
  setWindowTitle(tr("Compare drawings"));
  words_->setObjectName("comparison_words");
  words_->setWordWrap(true);
  tree_->setObjectName("comparison_figures");
  tree_->setAccessibleName(tr("Figures of the drawing"));
  tree_->setUniformRowHeights(true);
  tree_->header()->setStretchLastSection(false);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  auto* save = buttons->addButton(tr("&Save as CSV…"), QDialogButtonBox::ActionRole);
  save->setObjectName("comparison_save");
  auto* other = buttons->addButton(tr("&Another True Map…"), QDialogButtonBox::ActionRole);
  other->setObjectName("comparison_other");
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(save, &QPushButton::clicked, this, &ComparisonDialog::saveRequested);
  connect(other, &QPushButton::clicked, this, &ComparisonDialog::otherTruthRequested);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(words_);
  layout->addWidget(tree_, 1);
  layout->addWidget(buttons);
  resize(kComparisonSize);
}

void ComparisonDialog::setFigures(const QString& truth, const std::vector<SketchFigures>& columns) {
  const bool other_columns = columns.size() != columns_.size();
  columns_ = columns;
  words_->setText(tr("Against %1. The arrows lead from the true places to the drawn ones; a ring "
                     "alone is not drawn. What each figure says stands in its tooltip.")
                      .arg(truth));
  if (other_columns) {
    QStringList titles{tr("Figure"), tr("Drawing")};
    if (columns.size() > 1) titles << tr("Corrected map");
    tree_->clear();
    tree_->setColumnCount(static_cast<int>(titles.size()));
    tree_->setHeaderLabels(titles);
    tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  }
  fill();
}

/// Items stay, and with them what is folded and where one has scrolled to.
void ComparisonDialog::fill() {
  constexpr int kGroups = static_cast<int>(FigureGroup::Count);
  const bool first = tree_->topLevelItemCount() == 0;
  for (int i = 0; first && i < kGroups; ++i) {
    auto* group = new QTreeWidgetItem(tree_, {titleOf(static_cast<FigureGroup>(i))});
    group->setFirstColumnSpanned(true);
    group->setExpanded(true);
  }
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    std::array<int, kGroups> rows{};
    for (const NamedFigure& figure : namedFigures(columns_[column])) {
      const FigureWords words = figureWords(figure.name);
      if (words.title.isEmpty()) continue;  // what it is of, no figure
      const auto place = static_cast<int>(words.group);
      QTreeWidgetItem* group = tree_->topLevelItem(place);
      const int row = rows[static_cast<std::size_t>(place)]++;
      if (row == group->childCount()) {
        auto* item = new QTreeWidgetItem(group, {words.title});
        item->setToolTip(0, words.explanation);
      }
      const int cell = static_cast<int>(column) + 1;
      group->child(row)->setText(cell, figureValue(figure.name, figure.value));
      group->child(row)->setToolTip(cell, words.explanation);
      group->child(row)->setTextAlignment(cell, Qt::AlignRight | Qt::AlignVCenter);
    }
  }
}

}  // namespace handmap
