#include "widgets/run/panels/budget_table.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>

namespace handmap {

namespace {

constexpr double kSeen_ms = 0.05;  // what takes less is not there

QString milliseconds(double ms) { return QString::number(ms, 'f', ms < 9.95 ? 1 : 0); }

}  // namespace

QBrush stageBrush(std::size_t stage, const QPalette& palette) {
  QColor colour = palette.color(QPalette::Text);
  colour.setAlpha(stage + 1 == kStages.size() ? 110 : 190);
  return {colour, kStages[stage].pattern};
}

BudgetTable::BudgetTable(QWidget* parent) : QWidget(parent), verdict_(new QLabel) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 0, 8, 4);
  grid->setVerticalSpacing(0);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.85);
  setFont(small);
  int column = 1;
  for (const QString& title : {tr("Stage"), tr("Share"), tr("Median"), tr("95 % below")}) {
    auto* label = new QLabel(title);
    grid->addWidget(label, 0, column, column == 1 ? Qt::AlignLeft : Qt::AlignRight);
    ++column;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i] = {new QLabel, new QLabel(i < kStages.size() ? tr(kStages[i].name) : tr("all")),
                new QLabel, new QLabel, new QLabel};
    const int row = static_cast<int>(i) + 1;
    grid->addWidget(rows_[i].sample, row, 0);
    grid->addWidget(rows_[i].name, row, 1);
    grid->addWidget(rows_[i].share, row, 2, Qt::AlignRight);
    grid->addWidget(rows_[i].p50, row, 3, Qt::AlignRight);
    grid->addWidget(rows_[i].p95, row, 4, Qt::AlignRight);
  }
  verdict_->setWordWrap(true);
  grid->addWidget(verdict_, static_cast<int>(rows_.size()) + 1, 0, 1, 5);
  grid->setColumnStretch(1, 1);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  setAccessibleName(tr("Where the time of an observation goes"));
  paintSamples();
  setBudget({});
}

void BudgetTable::setBudget(const FrameBudget& budget) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool all = i == kStages.size();
    const FrameBudget::Line line = all ? budget.total() : budget.of(kStages[i].ms);
    const Row& row = rows_[i];
    const bool used = all || line.p95_ms >= kSeen_ms;
    for (QLabel* label : {row.sample, row.name, row.share, row.p50, row.p95}) {
      label->setVisible(used);
    }
    row.share->setText(all ? QString() : tr("%1 %").arg(line.share * 100.0, 0, 'f', 0));
    row.p50->setText(tr("%1 ms").arg(milliseconds(line.p50_ms)));
    row.p95->setText(tr("%1 ms").arg(milliseconds(line.p95_ms)));
  }
  const auto interval = budget.intervalMs();
  if (!interval) return verdict_->setText({});
  const double used = 100.0 * budget.total().p95_ms / *interval;
  verdict_->setText(
      used <= 100.0 ? tr("A frame comes every %1 ms; 95 of 100 frames need at most %2 % of that.")
                          .arg(milliseconds(*interval))
                          .arg(used, 0, 'f', 0)
                    : tr("A frame comes every %1 ms: too slow to keep up (95 of 100 frames need at "
                         "most %2 % of that).")
                          .arg(milliseconds(*interval))
                          .arg(used, 0, 'f', 0));
}

void BudgetTable::paintSamples() {
  for (std::size_t i = 0; i < kStages.size(); ++i) {
    QPixmap sample(14, 10);
    sample.fill(palette().color(QPalette::Base));
    QPainter painter(&sample);
    const QBrush brush = stageBrush(i, palette());
    painter.setPen(brush.color());
    painter.setBrush(brush);
    painter.drawRect(sample.rect().adjusted(0, 0, -1, -1));
    painter.end();
    rows_[i].sample->setPixmap(sample);
  }
}

void BudgetTable::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) paintSamples();
  QWidget::changeEvent(event);
}

}  // namespace handmap
