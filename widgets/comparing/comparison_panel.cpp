#include "widgets/comparing/comparison_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <array>

#include "widgets/comparing/figure_words.h"

namespace handmap {

namespace {

constexpr int kIndentation = 10;  // pixels
constexpr double kSmallFont = 0.85;

}  // namespace

ComparisonPanel::ComparisonPanel(QWidget* parent)
    : QWidget(parent), words_(new QLabel), tree_(new QTreeWidget) {
  setObjectName("comparison_panel");
  words_->setObjectName("comparison_words");
  words_->setWordWrap(true);
  tree_->setObjectName("comparison_figures");
  tree_->setAccessibleName(tr("Figures of the drawing"));
  tree_->setUniformRowHeights(true);
  // In a narrow panel there is to be room for the names beside two columns.
  tree_->setIndentation(kIndentation);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * kSmallFont);
  tree_->setFont(small);
  tree_->header()->setFont(small);
  tree_->header()->setStretchLastSection(false);
  auto* save = new QPushButton(tr("&Save as CSV…"));
  save->setObjectName("comparison_save");
  auto* other = new QPushButton(tr("&Another True Map…"));
  other->setObjectName("comparison_other");
  connect(save, &QPushButton::clicked, this, &ComparisonPanel::saveRequested);
  connect(other, &QPushButton::clicked, this, &ComparisonPanel::otherTruthRequested);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(words_);
  layout->addWidget(tree_, 1);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(other);
  buttons->addWidget(save);
  layout->addLayout(buttons);
}

void ComparisonPanel::setFigures(const QString& truth, const std::vector<SketchFigures>& columns) {
  const bool other_columns = columns.size() != columns_.size();
  columns_ = columns;
  words_->setText(tr("Against %1. The arrows lead from the true places to the drawn ones; a ring "
                     "alone is not drawn. What each figure says stands in its tooltip.")
                      .arg(truth));
  if (other_columns) {
    QStringList titles{tr("Figure"), tr("Drawing")};
    if (columns.size() > 1) titles << tr("Corrected");
    tree_->clear();
    tree_->setColumnCount(static_cast<int>(titles.size()));
    tree_->setHeaderLabels(titles);
    tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  }
  fill();
}

/// Items stay, and with them what is folded and where one has scrolled to.
void ComparisonPanel::fill() {
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
